import pytest

from tests.massive import inertial, joint, link
from tests.naming import naming
from tests.reported import messages, places, reported

MOMENTS = (2e-6, 2e-6, 1e-6)


def hand(left: str, right: str) -> str:
    return (
        link("hand")
        + link("left_finger", left)
        + link("right_finger", right)
        + joint("hand", "left_finger", "prismatic", "0 0.1 0")
        + joint("hand", "right_finger", "prismatic", "0 -0.1 0")
    )


def test_a_typo_of_a_digit() -> None:
    robot = hand(inertial(0.015, MOMENTS), inertial(0.15, MOMENTS))
    (found,) = reported("INE012", robot)
    assert found.message == naming("right_finger", "0.15 kg", "left_finger", "0.015 kg", "10")
    assert places("INE012", robot) == [(5, "0.15")]
    assert [(note.span.line, note.message) for note in found.related] == [
        (3, "'left_finger' has 0.015 kg")
    ]


def test_the_other_side() -> None:
    robot = hand(inertial(0.15, MOMENTS), inertial(0.015, MOMENTS))
    assert messages("INE012", robot) == [
        naming("right_finger", "0.015 kg", "left_finger", "0.15 kg", "10")
    ]


def test_moments() -> None:
    robot = hand(inertial(0.1, MOMENTS), inertial(0.1, (4e-6, 2e-6, 2.1e-6)))
    assert messages("INE012", robot) == [
        naming(
            "right_finger",
            "2e-06, 2.1e-06, 4e-06 kg·m²",
            "left_finger",
            "1e-06, 2e-06, 2e-06 kg·m²",
        )
    ]


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (inertial(0.1, MOMENTS), inertial(0.11, MOMENTS)),  # real parts differ
        (inertial(0.1, (3, 0.1, 0.2, 2, 0.3, 2)), inertial(0.1, (3, -0.1, 0.2, 2, -0.3, 2))),
        (inertial(0.1, MOMENTS), ""),  # INE004
        (inertial(0.1, MOMENTS), inertial(0.1, (1e-6, 1e-6, 9e-6))),  # INE003
    ],
)
def test_what_is_all_right_or_another_rule_s(left: str, right: str) -> None:
    assert messages("INE012", hand(left, right)) == []


def test_names_alone_make_no_pairs() -> None:
    # An arm with the joints s, l, u, r, b, t.
    robot = link("s") + link("link_l", inertial(5, (1, 1, 1))) + link("u")
    robot += link("link_r", inertial(3, (1, 1, 1)))
    robot += joint("s", "link_l") + joint("link_l", "u") + joint("u", "link_r")
    assert messages("INE012", robot) == []


@pytest.mark.parametrize(
    ("mass", "moments", "count", "expected"),
    [
        (0.93, MOMENTS, 4, naming("right_a", "0.93 kg", "left_a", "0.39 kg", "2.38")),
        (0.36, MOMENTS, 4, naming("right_a", "0.36 kg", "left_a", "0.39 kg", "1.08", "all other")),
        (
            0.39,
            (2.2e-6, 2e-6, 1e-6),
            4,
            naming(
                "right_a",
                "1e-06, 2e-06, 2.2e-06 kg·m²",
                "left_a",
                "1e-06, 2e-06, 2e-06 kg·m²",
                "all other",
            ),
        ),
        (
            0.395,  # the masses of the driven wheels of an AGV differ by 2 %, the moments by 10 %
            (2.2e-6, 2e-6, 1e-6),
            4,
            naming(
                "right_a",
                "1e-06, 2e-06, 2.2e-06 kg·m²",
                "left_a",
                "nearly the same",
                "1e-06, 2e-06, 2e-06 kg·m²",
                "all other",
            ),
        ),
        (0.36, MOMENTS, 3, ""),
        (0.375, MOMENTS, 4, ""),  # as a CAD program computes two wheels of a Bunker
    ],
)
def test_the_only_pair_that_differs(
    mass: float, moments: tuple[float, ...], count: int, expected: str
) -> None:
    """A digit of one foot of ROBOTIS OP3, whose other nine pairs are equal."""
    text = link("base")
    for name in "abcde"[: count + 1]:
        left, right = f"left_{name}", f"right_{name}"
        own = inertial(mass, moments) if name == "a" else inertial(0.39, MOMENTS)
        text += link(left, inertial(0.39, MOMENTS)) + link(right, own)
        text += joint("base", left, "revolute", "0 0.1 0")
        text += joint("base", right, "revolute", "0 -0.1 0")
    assert messages("INE012", text) == [expected] * bool(expected)


TENSOR = (0.01, 0.001, 0.0008, 0.01, 0.001, 0.008)
#: ixy and iyz have the other sign.
IMAGE = (0.01, -0.001, 0.0008, 0.01, -0.001, 0.008)
ONE_WRONG = (0.01, 0.001, 0.0008, 0.01, -0.001, 0.008)


def leg_pairs(*rights: tuple[tuple[float, ...], str]) -> str:
    """Pairs of legs, of which each right one has a tensor and a centre of mass."""
    text = link("base")
    for number, (tensor, center) in enumerate(rights):
        left, right = f"left_leg_{'abc'[number]}", f"right_leg_{'abc'[number]}"
        text += link(left, inertial(1, TENSOR, "0.01 0.02 -0.1"))
        text += link(right, inertial(1, tensor, center))
        text += joint("base", left, "revolute", f"{number} 0.1 0")
        text += joint("base", right, "revolute", f"{number} -0.1 0")
    return text


CENTER = "0.01 -0.02 -0.1"


@pytest.mark.parametrize(
    ("tensor", "center", "wrong", "value"),
    [
        (IMAGE, CENTER, "", ""),
        (ONE_WRONG, CENTER, "ixy", "0.001 kg·m²"),
        ((0.01, -0.001, -0.0008, 0.01, -0.001, 0.008), CENTER, "ixz", "-0.0008 kg·m²"),
        (IMAGE, "0.01 0.02 -0.1", "y of the", "0.02 m"),
        (IMAGE, "0.01 -0.02 0.1", "z of the", "0.1 m"),
        (IMAGE, "0.01 -0.04 -0.1", "", ""),
    ],
)
def test_one_wrong_sign(tensor: tuple[float, ...], center: str, wrong: str, value: str) -> None:
    found = messages("INE012", leg_pairs((IMAGE, CENTER), (IMAGE, CENTER), (tensor, center)))
    expected = [naming("right_leg_c", wrong, value, "left_leg_c")] if wrong else []
    assert found == expected


@pytest.mark.parametrize("side", ["left", "right"])
def test_the_center_that_is_outside_of_its_shapes(side: str) -> None:
    """A foot of ROBOTIS OP3: the counterpart that has its centre in its box is the right one."""
    text = leg_pairs(*[(IMAGE, CENTER)] * 3)
    left, right = (TENSOR, "0.01 0.02 -0.1"), (IMAGE, CENTER)
    own, other = (left, right) if side == "left" else (right, left)
    wrong = (ONE_WRONG if side == "right" else (0.01, -0.001, 0.0008, 0.01, 0.001, 0.008), other[1])
    before, name, after = text.partition(f'<link name="{side}_leg_c">')
    text = before + name + after.replace(inertial(1, *own), inertial(1, *wrong), 1)
    shape = '<visual><origin xyz="0.01 {} -0.1"/>'
    shape += '<geometry><box size="0.1 0.03 0.1"/></geometry></visual>'
    for word, y in (("left", "0.02"), ("right", "-0.02")):
        inside = f'<link name="{word}_leg_c">'
        text = text.replace(inside, inside + shape.format(y))
    found = messages("INE012", text)
    assert ["y of the" in message for message in found] == [True, False]
    assert all(message.startswith(f"link '{side}_leg_c'") for message in found)


def test_the_tensor_that_others_with_the_mesh_do_not_have() -> None:
    """Dyna1: a left foot has the tensor of the right one; the other left foot has its own."""
    text = leg_pairs(*[(IMAGE, CENTER)] * 3)
    before, name, after = text.partition('<link name="left_leg_c">')
    text = before + name + after.replace('ixz="0.0008"', 'ixz="-0.0008"', 1)
    assert ["'right_leg_c': ixz" in message for message in messages("INE012", text)] == [True]
    for side in ("left", "right"):
        mesh = f'<visual><geometry><mesh filename="{side}.stl"/></geometry></visual>'
        for leg in "abc":
            inside = f'<link name="{side}_leg_{leg}">'
            text = text.replace(inside, inside + mesh)
    assert ["'left_leg_c': ixz" in message for message in messages("INE012", text)] == [True]


def test_copies_have_no_wrong_sign() -> None:
    copies = ((TENSOR, "0.01 0.02 -0.1"),) * 2
    assert messages("INE012", leg_pairs(*copies)) == []
    assert messages("INE012", leg_pairs(*copies, (IMAGE, CENTER))) == []
    assert messages("INE012", leg_pairs((IMAGE, CENTER), *copies)) == []


def test_the_same_part_on_both_sides() -> None:
    """The cameras of an ANYmal C: one part, turned by half a turn, with one tensor."""
    text = leg_pairs((IMAGE, CENTER), (IMAGE, CENTER), (ONE_WRONG, CENTER))
    for side, name in (("left", "a"), ("right", "b")):
        inside = f'<link name="{side}_leg_c">'
        mesh = f'<visual><geometry><mesh filename="{name}.stl"/></geometry></visual>'
        text = text.replace(inside, inside + mesh)
    assert len(messages("INE012", text)) == 1
    same = text.replace("b.stl", "a.stl")
    assert messages("INE012", same) == []
    # The hips of a Go1: the part is turned over in the frame of the right link.
    start, right = same.split('<link name="right_leg_c">')
    over = right.replace("<visual>", '<visual><origin rpy="3.14159 0 0"/>', 1)
    assert len(messages("INE012", f'{start}<link name="right_leg_c">{over}')) == 1


def test_small_coordinates_of_copies_that_are_turned() -> None:
    """A Mulinex: the modules of the right legs are those of the left, turned by half a turn."""
    turned = [(IMAGE, "0.004 -0.02 -0.1")] * 2
    text = leg_pairs(*turned, (IMAGE, "0.004 0.02 -0.1")).replace("0.01 0.02", "-0.004 0.02")
    assert messages("INE012", text) == [naming("right_leg_c", "y of the", "0.02 m", "left_leg_c")]

"""JNT037: see the rule."""

import pytest

from tests.growth import executed_lines
from tests.naming import naming
from tests.reported import messages
from urdfkit import check
from urdfkit.text.source import Source

LINK = (
    '<link name="{}"><visual><origin xyz="0 0 0.1"/><geometry><box size="0.1 0.1 0.2"/></geometry>'
    "</visual></link>\n"
)


def robot(xyz: str, rpy: str = "0 0 0", kind: str = "fixed") -> str:
    joint = f'<joint name="j" type="{kind}"><parent link="a"/><child link="b"/>'
    limit = '<limit lower="0" upper="1" effort="1" velocity="1"/>'
    origin = f'<origin xyz="{xyz}" rpy="{rpy}"/>'
    return f"{LINK.format('a')}{LINK.format('b')}{joint}{origin}{limit}</joint>"


@pytest.mark.parametrize(
    ("xyz", "gap"), [("0 0 2.4", "2.2"), ("3 0 0", "2.9"), ("0 -24 0", "23.9")]
)
def test_far_in_the_air(xyz: str, gap: str) -> None:
    assert messages("JNT037", robot(xyz)) == [naming("j", "b", f"{gap} m", "a", "0.2 m")]


@pytest.mark.parametrize(
    ("xyz", "rpy", "kind"),
    [
        ("0 0 0.2", "0 0 0", "fixed"),
        ("0 0 0.9", "0 0 0", "fixed"),
        ("0 0 0.95", "3.14159 0 0", "fixed"),  # it hangs down towards the other
        ("0 0 5", "0 0 0", "prismatic"),  # it moves along
    ],
)
def test_what_is_near_or_moves_there_is_calm(xyz: str, rpy: str, kind: str) -> None:
    assert messages("JNT037", robot(xyz, rpy, kind)) == []


def test_frames_without_shapes_are_anywhere() -> None:
    bare = robot("0 0 5").replace(LINK.format("b"), '<link name="b"/>')
    assert messages("JNT037", bare) == []


def test_the_cost_grows_with_the_links() -> None:
    def lines(number: int) -> int:
        text = LINK.format("hub") + "".join(
            f'{LINK.format(f"l{n}")}<joint name="j{n}" type="revolute"><parent link="hub"/>'
            f'<child link="l{n}"/><origin xyz="{n} 0 0"/></joint>'
            for n in range(2, number + 2)
        )
        return executed_lines(lambda: messages("JNT037", text))

    assert lines(400) < 50 * lines(10)


def chain(*parents: str) -> str:
    """Links ``l_1`` and so on, with the number of the parent link of each; 0 is the base."""
    links = "".join(f'<link name="l_{n}"/>\n' for n in range(len(parents) + 1))
    return links + "".join(
        f'<joint name="j_{n}" type="revolute">\n<parent link="l_{parent}"/><child link="l_{n}"/>'
        '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>\n'
        for n, parent in enumerate(parents, 1)
    )


def test_a_numbered_link_skips_the_one_before() -> None:
    assert messages("JNT037", chain("0", "1", "2", "2", "4")) == [
        naming("j_4", "l_4", "l_2", "l_3")
    ]


def test_a_link_of_a_numbered_joint_skips_the_one_before() -> None:
    """A SCARA arm whose links have names of their own."""
    text = chain("0", "1", "2", "2", "4")
    for number, name in enumerate(("base", "rail", "upper", "lower", "hand", "tip")):
        text = text.replace(f'"l_{number}"', f'"{name}"')
    assert messages("JNT037", text) == [naming("j_4", "hand", "upper", "lower")]


@pytest.mark.parametrize(
    "parents",
    [
        ("0", "1", "2", "3", "4"),
        ("0", "1", "2", "2"),  # the two fingers of a gripper
        ("0", "1", "1", "2", "3"),  # fingers with two links each
        ("0", "0", "0", "0"),  # wheels
    ],
)
def test_chains_and_branches_of_numbered_links(parents: tuple[str, ...]) -> None:
    assert messages("JNT037", chain(*parents)) == []


def test_a_name_of_many_numbers() -> None:
    """The first eight are tried: each makes two names of the same length."""

    def work(count: int) -> int:
        name = "1a" * count
        links = f'<link name="base"/><link name="{name}"/>'
        ends = f'<parent link="base"/><child link="{name}"/>'
        joint = f'<joint name="j" type="continuous">{ends}</joint>'
        source = Source("r.urdf", f'<robot name="r">{links}{joint}</robot>'.encode())
        return executed_lines(lambda: check(source, select=["JNT037"]))

    work(10)  # imports
    assert work(2000) < 1.1 * work(200)


def test_a_tool_half_a_metre_from_a_small_gripper() -> None:
    """A JetCobot with 0.5 for 0.05 m in the origin of its tool centre point."""
    small = robot("0.5 0 0").replace('"0.1 0.1 0.2"', '"0.05 0.05 0.05"')
    assert messages("JNT037", small) == [naming("j", "b", "0.45 m", "a", "0.05 m")]


FOOT = '<collision><geometry><sphere radius="0.02"/></geometry></collision>'


@pytest.mark.parametrize(
    ("z", "shape", "is_found"),
    [
        ("-0.21", FOOT, False),
        ("-0.42", FOOT, True),
        ("-0.42", FOOT.replace("collision", "visual"), False),  # a marker
    ],
)
def test_a_foot_that_does_not_touch_its_leg(z: str, shape: str, is_found: bool) -> None:
    """A Go1 with thigh and calf in the origin of its foot."""
    text = robot("0 0 -0.2", kind="revolute") + f'<link name="foot">{shape}</link>'
    text += '<joint name="f" type="fixed"><parent link="b"/><child link="foot"/>'
    text = text.replace('xyz="0 0 0.1"', 'xyz="0 0 -0.1"') + f'<origin xyz="0 0 {z}"/></joint>'
    expected = [naming("f", "foot", "0.2 m", "b", "0.2 m")]
    assert messages("JNT037", text) == (expected if is_found else [])

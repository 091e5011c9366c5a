"""JNT031: see the rule."""

import pytest

from tests.reported import messages

PART = """\
<link name="{side}"/><joint name="{side}_joint" type="continuous"><parent link="base"/>
<child link="{side}"/><origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 1 0"/></joint>
"""


def robot(left: str, right: str, rpy: str = "0 0 0") -> str:
    one = PART.format(side="left", xyz=left, rpy="0 0 0")
    return f'<link name="base"/>{one}{PART.format(side="right", xyz=right, rpy=rpy)}'


@pytest.mark.parametrize(
    ("right", "reason"),
    [
        ("0.1 0.2 -0.05", "is at the place of"),
        ("-0.1 -0.2 -0.05", "is on the other side in y and in x, too, of"),
        ("0.1 -0.2 0.05", "is on the other side in y and in z, too, of"),
    ],
)
def test_a_slip_of_a_sign(right: str, reason: str) -> None:
    assert messages("JNT031", robot("0.1 0.2 -0.05", right)) == [
        f"joint 'right_joint' at {right} m {reason} its twin 'left_joint' at 0.1 0.2 -0.05 m"
    ]


@pytest.mark.parametrize(
    ("left", "right", "rpy"),
    [
        ("0.1 0.2 0", "0.1 -0.2 0", "0 0 0"),
        ("0.1 0.2 0", "0.103 -0.2 0", "0 0 0"),  # robots are not quite symmetric
        ("0.1 0.2 0", "0.1 -0.23 0", "0 0 0"),  # one pair tells nothing of the middle
        ("0.1 0.2 0", "0.13 -0.2 0.02", "0 0 0"),
        ("0.1 0 0", "0.1 0 0", "0 0 0"),  # two axes of one neck
        ("0.1 0.2 0", "-0.1 -0.2 0", "0 0 3.14159"),  # turned about z
    ],
)
def test_what_may_be_meant_is_calm(left: str, right: str, rpy: str) -> None:
    assert messages("JNT031", robot(left, right, rpy)) == []


def test_cameras_that_do_not_move() -> None:
    fixed = robot("0.1 0.2 0", "0.1 0.2 0").replace("continuous", "fixed")
    assert messages("JNT031", fixed) == [
        "joint 'right_joint' at 0.1 0.2 0 m is at the place of its twin 'left_joint' at 0.1 0.2 0 m"
    ]


@pytest.mark.parametrize(
    ("right", "shift"),
    [("0.13 -0.2 -0.05", "0.03 m forward"), ("0.1 -0.2 -0.15", "0.1 m down")],
)
def test_one_that_is_only_shifted(right: str, shift: str) -> None:
    assert messages("JNT031", robot("0.1 0.2 -0.05", right)) == [
        f"joint 'right_joint' is {shift} of where its twin 'left_joint' would put it"
    ]


def legs(*rights: str) -> str:
    """Three pairs of joints: two on the base, and a knee below the hip."""
    places = [("hip", "0.3 0.1 0", "base"), ("knee", "0 0.05 -0.2", "SIDE_hip")]
    text = '<link name="base"/>'
    places.append(("arm", "0 0.2 0.4", "base"))
    for (name, left, parent), right in zip(places, rights, strict=True):
        for side, xyz in (("left", left), ("right", right)):
            inside = (
                f'<origin xyz="{xyz}"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
                f'<parent link="{parent.replace("SIDE", side)}"/><child link="{side}_{name}"/>'
            )
            text += f'<link name="{side}_{name}"/>'
            text += f'<joint name="{side}_{name}_joint" type="revolute">{inside}</joint>'
    return text


HIP, KNEE, ARM = "0.3 -0.1 0", "0 -0.05 -0.2", "0 -0.2 0.4"


@pytest.mark.parametrize(
    ("rights", "found"),
    [
        ((HIP, KNEE, ARM), []),
        ((HIP, KNEE, "0 -0.25 0.4"), []),  # an arm that is longer
        ((HIP, KNEE, "0 -0.25 0.3"), ["arm_joint' is 0.05 m to the right and 0.1 m down"]),
        ((HIP, "0.02 -0.05 -0.25", ARM), ["knee_joint' is 0.02 m forward and 0.05 m down"]),
        (("0.3 -0.15 0", KNEE, ARM), []),  # only the arms are left to compare with
        (("0.35 -0.1 0", KNEE, ARM), ["hip_joint' is 0.05 m forward"]),  # and not the knee
        ((HIP, "0.02 -0.05 -0.25", "0 -0.25 0.4"), []),  # a robot that is no mirror image
    ],
)
def test_one_pair_of_several(rights: tuple[str, ...], found: list[str]) -> None:
    reported = [message.partition(" of where")[0] for message in messages("JNT031", legs(*rights))]
    assert reported == [f"joint 'right_{one}" for one in found]

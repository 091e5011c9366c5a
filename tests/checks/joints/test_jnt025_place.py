"""Joints whose place is not that of a mirror image."""

import pytest

from tests.naming import naming
from tests.reported import messages

PART = """\
<link name="{side}"/><joint name="{side}_joint" type="continuous"><parent link="base"/>
<child link="{side}"/><origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 1 0"/></joint>
"""


def wheels(left: str, right: str, rpy: str = "0 0 0") -> str:
    one = PART.format(side="left", xyz=left, rpy="0 0 0")
    return f'<link name="base"/>{one}{PART.format(side="right", xyz=right, rpy=rpy)}'


@pytest.mark.parametrize(
    ("right", "rpy", "reason"),
    [
        ("0.1 0.2 -0.05", "0 0 0", "same place"),
        ("0.1 0.2 -0.05", "0 0 -1.7e-15", "same place"),  # written by an exporter
        ("-0.1 -0.2 -0.05", "0 0 0", "also in x"),
        ("0.1 -0.2 0.05", "0 0 0", "also in z"),
    ],
)
def test_a_typo_of_a_sign(right: str, rpy: str, reason: str) -> None:
    assert messages("JNT025", wheels("0.1 0.2 -0.05", right, rpy)) == [
        naming("right_joint", f"{right} m", reason, "left_joint", "0.1 0.2 -0.05 m")
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
def test_plausible_places(left: str, right: str, rpy: str) -> None:
    assert messages("JNT025", wheels(left, right, rpy)) == []


def test_cameras_that_do_not_move() -> None:
    fixed = wheels("0.1 0.2 0", "0.1 0.2 0").replace("continuous", "fixed")
    assert messages("JNT025", fixed) == [
        naming("right_joint", "0.1 0.2 0 m", "left_joint", "0.1 0.2 0 m")
    ]


def casters(rear_right: str) -> str:
    """Four casters, of which the front ones and the left rear one are mirror images."""
    places = {"fl": "0.3 0.2 -0.1", "fr": "0.3 -0.2 -0.1", "rl": "-0.3 0.2 -0.1", "rr": rear_right}
    parts = (PART.format(side=side, xyz=xyz, rpy="0 0 0") for side, xyz in places.items())
    return '<link name="base"/>' + "".join(parts).replace("continuous", "fixed")


@pytest.mark.parametrize(
    ("place", "reason"),
    [
        ("-0.3 -0.2 -0.1", ""),
        ("-0.3 -0.2 -0.05", "higher"),
        ("-0.3 -0.2 -0.2", "lower"),
        ("-0.25 -0.2 -0.1", "forward"),
        ("-0.4 -0.2 -0.1", "back"),
        ("-0.25 -0.2 -0.05", ""),  # differs in two coordinates
        ("-0.3 -0.25 -0.1", ""),
    ],
)
def test_the_odd_one_of_four_corners(place: str, reason: str) -> None:
    expected = naming("rr_joint", f"{place} m", reason, "rl_joint", "-0.3 0.2 -0.1 m")
    assert messages("JNT025", casters(place)) == ([expected] if reason else [])


def test_a_corner_at_the_place_of_another() -> None:
    """Robotnik's RBCAR, whose origin is between the rear wheels."""
    text = casters("1.9 -0.2 -0.1").replace('"0.3 ', '"1.9 ').replace('"-0.3 ', '"0.1 ')
    assert messages("JNT025", text) == [
        naming("rr_joint", "1.9 -0.2 -0.1 m", "forward", "rl_joint", "0.1 0.2 -0.1 m")
    ]


@pytest.mark.parametrize(
    ("right", "shift"),
    [("0.13 -0.2 -0.05", ("0.03 m", "forward")), ("0.1 -0.2 -0.15", ("0.1 m", "down"))],
)
def test_one_that_is_only_shifted(right: str, shift: tuple[str, str]) -> None:
    assert messages("JNT025", wheels("0.1 0.2 -0.05", right)) == [
        naming("right_joint", *shift, "left_joint")
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
        (
            (HIP, KNEE, "0 -0.25 0.3"),
            ["arm_joint", "0.05 m", "right", "0.1 m", "down", "left_arm_joint"],
        ),
        (
            (HIP, "0.02 -0.05 -0.25", ARM),
            ["knee_joint", "0.02 m", "forward", "0.05 m", "down", "left_knee_joint"],
        ),
        (("0.3 -0.15 0", KNEE, ARM), []),  # only the arms are left to compare with
        (
            ("0.35 -0.1 0", KNEE, ARM),
            ["hip_joint", "0.05 m", "forward", "left_hip_joint"],
        ),  # and not the knee
        ((HIP, "0.02 -0.05 -0.25", "0 -0.25 0.4"), []),  # a robot that is no mirror image
        (("0.35 -0.1 0", "-0.05 -0.05 -0.2", ARM), []),  # igus_op: along the axis of the hip
    ],
)
def test_one_pair_of_several(rights: tuple[str, ...], found: list[str]) -> None:
    expected = [naming(f"right_{found[0]}", *found[1:])] if found else []
    assert messages("JNT025", legs(*rights)) == expected


@pytest.mark.parametrize(("toe", "count"), [("0.301 -0.3 0", 1), ("0.303 -0.3 0", 0)])
def test_next_to_a_pair_that_is_slightly_asymmetric(toe: str, count: int) -> None:
    """Sigmaban: the thighs differ by 1 mm."""
    text = legs(HIP, "0 -0.05 -0.22", ARM)
    for side, xyz in (("left", "0.3 0.3 0"), ("right", toe)):
        inside = f'<origin xyz="{xyz}"/><parent link="base"/><child link="{side}_toe"/>'
        text += f'<link name="{side}_toe"/><joint name="{side}_toe" type="continuous">{inside}'
        text += "</joint>"
    assert len(messages("JNT025", text)) == count


@pytest.mark.parametrize(("right", "count"), [("0 0.2 0.01", 0), ("0 0.2 0.015", 1)])
def test_an_arm_that_is_mounted_turned_is_no_mirror_image(right: str, count: int) -> None:
    """Atlas: both arms are the same product, and their wrists 9 mm aside of the elbows."""
    text = legs(HIP, "RIGHT", ARM).replace('"0.3 -0.1 0"', '"0.3 -0.1 0" rpy="3.14159265 0 0"')
    text = text.replace('"0 0.05 -0.2"', '"0 0.2 0.01"').replace("RIGHT", right)
    assert len(messages("JNT025", text)) == count


def test_the_same_place_as_the_other_side_with_its_rotation() -> None:
    front = PART.format(side="front_left", xyz="1 1 0", rpy="0 0 0")
    front += PART.format(side="front_right", xyz="1 -1 0", rpy="3.14 0 0")
    rear = PART.format(side="rear_left", xyz="-1 1 0", rpy="0 0 0")
    for xyz, count in (("-1 1 0", 1), ("-1 -1 0", 0)):
        other = PART.format(side="rear_right", xyz=xyz, rpy="3.14 0 0")
        text = f'<link name="base"/>{front}{rear}{other}'
        assert sum("same place" in one for one in messages("JNT025", text)) == count


@pytest.mark.parametrize(
    ("right", "count"),
    [
        ("0.05 -0.01 0", 0),
        ("0.05 -0.02 0", 1),
        ("-0.05 0.01 0", 0),  # to both sides of another plane of the palm
    ],
)
def test_fingers_on_a_palm_that_is_turned(right: str, count: int) -> None:
    """The gripper of a youBot: when all joints of its arm are zero, the palm looks aside."""
    palm = '<parent link="base"/><child link="palm"/>'
    text = legs(HIP, KNEE, ARM) + '<link name="palm"/>'
    text += f'<joint name="wrist" type="fixed"><origin rpy="0.3 0.2 2.9"/>{palm}</joint>'
    for side, xyz in (("left", "0.05 0.01 0"), ("right", right)):
        inside = f'<origin xyz="{xyz}"/><parent link="palm"/><child link="{side}_finger"/>'
        text += f'<link name="{side}_finger"/><joint name="{side}_finger" type="continuous">'
        text += f"{inside}</joint>"
    assert len(messages("JNT025", text)) == count


@pytest.mark.parametrize(
    ("name", "height", "found"),
    [
        ("caster", "-0.07", ["left_caster_joint"]),
        ("caster", "-0.15", ["right_caster_joint"]),
        ("caster", "-0.14", []),
        ("lamp", "-0.07", []),
    ],
)
def test_one_of_two_casters_is_higher(name: str, height: str, found: list[str]) -> None:
    text = '<link name="base"/>' + "".join(
        f'<link name="{side}_{name}"/><joint name="{side}_{name}_joint" type="fixed">'
        f'<parent link="base"/><child link="{side}_{name}"/><origin xyz="-0.6 {y} {z}"/></joint>'
        for side, y, z in (("left", "0.2", height), ("right", "-0.2", "-0.14"))
    )
    heard = messages("JNT025", text)
    assert [one.split("'")[1] for one in heard] == found
    assert all("higher" in one for one in heard)

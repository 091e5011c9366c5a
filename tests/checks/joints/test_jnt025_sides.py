"""Axes, limits and parents of two arms, and what is no mirror image of them."""

import pytest

from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import messages, places, reported

REVOLUTE = limit("-1", "2", "80", "11")
PLACES = ("0.1 0.2 0", "0.1 -0.2 0")


def hip(side: str, xyz: str, axis: str, kind: str = "revolute", rpy: str = "0 0 0") -> str:
    content = f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>{limit("-1", "1")}'
    return joint(f"{side}_hip", kind, content)


def hips(left: str, right: str, kind: str = "revolute", places: tuple[str, str] = PLACES) -> str:
    return robot(hip("left", places[0], left, kind), hip("right", places[1], right, kind))


def test_one_letter() -> None:
    text = hips("0 1 0", "1 0 0")
    (message,) = messages("JNT025", text)
    assert message == naming("right_hip", "1 0 0", "left_hip", "0 1 0")
    assert places("JNT025", text) == [(6, '<axis xyz="1 0 0"/>')]


def test_the_frames_count() -> None:
    turned = hip("right", PLACES[1], "1 0 0", rpy="0 0 1.5708")
    assert messages("JNT025", robot(hip("left", PLACES[0], "0 1 0"), turned)) == []
    assert len(messages("JNT025", robot(hip("left", PLACES[0], "1 0 0"), turned))) == 1


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("0 1 0", "0 1 0"),
        ("0 1 0", "0 -1 0"),
        ("1 0 0", "-1 0 0"),
        ("0.6 0.8 0", "0.6 -0.8 0"),
        ("0.6 0.8 0", "-0.6 0.8 0"),
    ],
)
def test_mirror_images_to_either_side(left: str, right: str) -> None:
    assert messages("JNT025", hips(left, right)) == []


@pytest.mark.parametrize(
    "other",
    [
        hips("0 1 0", "1 0 0", "prismatic"),
        hips("0 1 0", "1 0 0", places=("0.1 0.2 0", "0.3 -0.2 0")),  # two arms on a table
        hips("0 1 0", "1 0 0", places=("0.1 0 0", "0.1 0 0")),
        robot(hip("upper", PLACES[0], "0 1 0"), hip("lower", PLACES[1], "1 0 0")),
        hips(
            "1 1 1", "1 1 1"
        ),  # balls of warehouse_robot_simulation: the message named no difference
    ],
)
def test_what_is_no_mirror_image(other: str) -> None:
    assert not any("turns about" in message for message in messages("JNT025", other))


def corners(offset: str) -> str:
    """Four wheels, each on an arm; ``offset`` is the y of the right front wheel on its arm."""
    text = '<link name="base"/>'
    for side, x, y in (("fl", 1, 1), ("fr", 1, -1), ("rl", -1, 1), ("rr", -1, -1)):
        inside = f'<origin xyz="{x} {y} 0"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
        text += joint(f"{side}_arm", "revolute", inside)
        place = offset if side == "fr" else str(0.1 * y)
        wheel = f'<origin xyz="0 {place} 0"/><axis xyz="0 1 0"/>'
        text += joint(f"{side}_wheel", "continuous", wheel, f"{side}_arm_link")
    return text


def test_an_offset_that_was_copied() -> None:
    assert messages("JNT025", corners("-0.1")) == []
    assert messages("JNT025", corners("0.1")) == [naming("fr_wheel", "0.2 m", "left", "fl_wheel")]
    assert messages("JNT025", corners("-0.2")) == [
        naming("fr_wheel", "-0.2 m", "0.1 m")
    ]  # not copied


def arms(parent: str, limits: dict[str, tuple[float, float]] | None = None) -> str:
    """Two arms of three joints; ``parent`` of the right elbow, and limits that are not [-1, 2]."""
    text = '<link name="base"/>'
    for side, y in (("left", 1), ("right", -1)):
        above = "base"
        for name in ("shoulder", "elbow", "wrist"):
            low, high = (limits or {}).get(f"{side}_{name}", (-1, 2))
            axis = "1 0 0" if name == "elbow" else "0 1 0"
            inside = f'<origin xyz="0 {0.2 * y} 0"/><axis xyz="{axis}"/>'
            inside += limit(str(low), str(high))
            owner = parent if (side, name) == ("right", "elbow") else above
            text += joint(f"{side}_{name}", "revolute", inside, owner)
            above = f"{side}_{name}_link"
    return text


#: About x, mirror images turn in opposite directions.
MIRRORED = {"right_elbow": (-2.0, 1.0)}


def test_the_parent_on_the_other_side() -> None:
    assert messages("JNT025", arms("right_shoulder_link", MIRRORED)) == []
    (found,) = reported("JNT025", arms("left_shoulder_link", MIRRORED))
    assert found.message == naming(
        "right_elbow", "left_shoulder_link", "left_elbow", "right_shoulder_link"
    )
    assert found.help == naming("right_shoulder_link")
    assert found.span.text == '<parent link="left_shoulder_link"/>'


@pytest.mark.parametrize(
    ("limits", "names"),
    [
        ({}, ["right_elbow"]),
        (MIRRORED, []),
        (MIRRORED | {"right_wrist": (-2.0, 1.0)}, ["right_wrist"]),
        ({"right_wrist": (-2.0, 1.0)}, []),  # two of three: no pattern
    ],
)
def test_limits_that_do_not_follow_the_axes(
    limits: dict[str, tuple[float, float]], names: list[str]
) -> None:
    found = messages("JNT025", arms("right_shoulder_link", limits))
    assert [message.partition(":")[0] for message in found] == [f"joint '{one}'" for one in names]


def test_a_robot_that_faces_along_y() -> None:
    """Poppy: the root frame of the CAD program has x to the side."""
    text = arms("right_shoulder_link").replace("0 0.2 0", "0.2 0 0").replace("0 -0.2 0", "-0.2 0 0")
    text = text.replace('"1 0 0"', '"0 -1 0"').replace('"0 1 0"', '"1 0 0"')
    (message,) = messages("JNT025", text)
    assert message.startswith("joint 'right_elbow': the mirror image of the limits")


@pytest.mark.parametrize(("offset", "count"), [("0.0015", 1), ("0.01", 0)])
def test_limits_of_arms_that_are_slightly_asymmetric(offset: str, count: int) -> None:
    """Wolfgang: the thighs differ by 1.5 mm, and both knees have the same limits."""
    text = arms("right_shoulder_link")
    assert text.count("0 -0.2 0") == 3
    text = text.replace("0 -0.2 0", f"{offset} -0.2 0", 1)
    assert sum("mirror image of the limits" in each for each in messages("JNT025", text)) == count


def with_mesh(text: str, *links: str) -> str:
    """The robot with one mesh as the visual of several links."""
    for name in links:
        mesh = '<visual><geometry><mesh filename="package://p/a.stl"/></geometry></visual>'
        assert f'<link name="{name}"/>' in text
        text = text.replace(f'<link name="{name}"/>', f'<link name="{name}">{mesh}</link>')
    return text


def test_the_same_arm_on_both_sides() -> None:
    """An ARX Lift, an ALOHA and a bimanual SO-101: an arm is no mirror image of itself."""
    same = with_mesh(arms("right_shoulder_link"), "left_elbow_link", "right_elbow_link")
    assert messages("JNT025", same) == []
    assert messages("JNT025", with_mesh(corners("0.1"), "fl_arm_link", "fr_arm_link")) == []
    wheels = with_mesh(corners("0.1"), "fl_wheel_link", "fr_wheel_link")
    assert len(messages("JNT025", wheels)) == 1


def test_the_same_arm_on_both_sides_with_a_plain_base() -> None:
    """A dual arm on a Summit XL: the mesh comes below the joint with the offset."""
    text = corners("0.1").replace('"continuous"', '"revolute"')
    text = text.replace('<axis xyz="0 1 0"/>', f'<axis xyz="0 1 0"/>{limit("-1", "1")}')
    for side in ("fl", "fr"):
        turn = f'<axis xyz="0 0 1"/>{limit("-1", "1")}'
        text += joint(f"{side}_hand", "revolute", turn, f"{side}_wheel_link")
    assert len(messages("JNT025", text)) == 1
    assert messages("JNT025", with_mesh(text, "fl_hand_link", "fr_hand_link")) == []


def test_one_part_that_is_turned_over_for_the_other_side() -> None:
    """The hips of a Go1: one mesh, and in the frames of the right links it is turned over."""
    start, right = with_mesh(corners("0.1"), "fl_arm_link", "fr_arm_link").split("fr_arm_link", 1)
    over = right.replace("<visual>", '<visual><origin rpy="3.14159 0 0"/>', 1)
    assert len(messages("JNT025", f"{start}fr_arm_link{over}")) == 1


def test_a_gripper_that_both_hands_have() -> None:
    """A NAO: both hands open from 0 to 1; Romeo's gripper is at the same side of both wrists."""
    text = arms("right_shoulder_link", MIRRORED)
    for side in ("left", "right"):
        place = '<origin xyz="0.06 -0.02 0"/><axis xyz="1 0 0"/>' + limit("0", "1")
        text += joint(f"{side}_hand", "revolute", place, f"{side}_wrist_link")
        finger = limit("0", "1") + f'<mimic joint="{side}_hand"/>'
        text += joint(f"{side}_tip", "prismatic", finger, f"{side}_wrist_link")
    assert messages("JNT025", text) == []


def test_numbers_that_are_not_mirrored() -> None:
    """The first finger of a NAO's left hand is where the second finger of the right hand is."""
    text = arms("right_shoulder_link", MIRRORED)
    for side in ("left", "right"):
        for number, y in ((1, 0.01), (2, -0.01)):
            place = f'<origin xyz="0.06 {y} 0"/>' + limit("-1", "1")
            text += joint(f"{side}_finger_{number}", "revolute", place, f"{side}_wrist_link")
            tip = f'<origin xyz="0.02 0 0"/>{limit("-1", "1")}'
            text += joint(f"{side}_tip_{number}", "revolute", tip, f"{side}_finger_{number}_link")
    assert messages("JNT025", text) == []


def test_one_side_is_fixed() -> None:
    text = arms("right_shoulder_link", MIRRORED)
    assert messages("JNT025", text) == []

    def fixed(text: str, name: str) -> str:
        return text.replace(f'name="{name}" type="revolute"', f'name="{name}" type="fixed"')

    (finding,) = reported("JNT025", fixed(text, "left_wrist"))
    assert finding.message == naming("left_wrist", "fixed", "right_wrist", "revolute")
    assert finding.span.text.startswith('<joint name="left_wrist"')
    both = fixed(fixed(text, "left_wrist"), "right_wrist")
    assert messages("JNT025", both) == []
    locked = fixed(fixed(text, "left_wrist"), "left_elbow")  # an arm that is locked
    assert not any("is fixed" in message for message in messages("JNT025", locked))
    plain = fixed(text, "left_wrist").replace(limit("-1", "2"), "")
    assert not any("is fixed" in message for message in messages("JNT025", plain))


def test_tips_of_the_fingers_of_one_hand() -> None:
    """rai-robotModels: the right hand of Baxter is 1.1 m beside the plane of the robot."""
    text = "".join(
        joint(
            f"{side}_{part}",
            "revolute",
            f'<origin xyz="0 {y} 0.2" rpy="0 0 {y}"/>{limit("-1", "1")}',
            parent,
        )
        for side, y in (("left", 1), ("right", -1))
        for part, parent in (("shoulder", "base"), ("elbow", f"{side}_shoulder_link"))
    )
    text += joint("suction_cup", "fixed", "", "left_elbow_link")
    for side, y in (("l", 0.02), ("r", -0.02)):
        slide = limit("0", "0.02")
        text += joint(f"hand_{side}_finger", "prismatic", slide, "right_elbow_link")
        tip = f'<origin xyz="0 {y} 0.1"/>'
        text += joint(f"hand_{side}_tip", "fixed", tip, f"hand_{side}_finger_link")
    assert messages("JNT025", robot(text)) == []


@pytest.mark.parametrize(
    ("sole", "other", "found"),
    [
        ("left", "left", []),
        ("right", "left", [naming("left_sole", "right_foot_link", "right_sole", "left_foot_link")]),
        ("right", "right", []),  # no other pair is on both feet
    ],
)
def test_both_soles_on_one_foot(sole: str, other: str, found: list[str]) -> None:
    """Frames at the feet, of which one was copied."""
    text = ""
    for side, parents in (("left", (sole, other)), ("right", ("right", "right"))):
        text += joint(f"{side}_foot", "revolute", REVOLUTE)
        for name, parent in zip(("sole", "toe"), parents, strict=True):
            text += joint(f"{side}_{name}", "fixed", "", f"{parent}_foot_link")
    same = [one for one in messages("JNT025", robot(text)) if "has the counterpart" in one]
    assert same == found


def feet(parent: str, inside: str = '<axis xyz="1 0 0"/>', side: str = "right") -> str:
    """Two legs with a foot each; that of a side is a child of ``parent``."""
    text = '<link name="base"/>'
    for each, y in (("left", 1), ("right", -1)):
        hip = f'<origin xyz="0 {0.1 * y} 0"/><axis xyz="0 1 0"/>{limit("-1", "1")}'
        text += joint(f"{each}_ankle", "revolute", hip, "base")
        owner = parent if each == side else f"{each}_ankle_link"
        foot = inside if each == side else '<axis xyz="1 0 0"/>'
        text += joint(f"{each}_foot", "revolute", foot + limit("-1", "1"), owner)
    return text


def test_the_last_joint_hangs_on_the_other_side() -> None:
    assert messages("JNT025", feet("right_ankle_link")) == []
    assert messages("JNT025", feet("left_ankle_link")) == [
        naming("right_foot", "left_ankle_link", "left_foot", "right_ankle_link")
    ]
    assert messages("JNT025", feet("right_ankle_link", side="left")) == [
        naming("left_foot", "right_ankle_link", "right_foot", "left_ankle_link")
    ]
    fingers = feet("left_ankle_link", '<origin xyz="0 0 0.1"/><axis xyz="1 0 0"/>')
    assert messages("JNT025", fingers) == []
    assert messages("JNT025", feet("left_ankle_link", '<axis xyz="-1 0 0"/>')) == []

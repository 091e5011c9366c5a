import pytest

from tests.jointed import joint, limit, robot
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Confidence

REVOLUTE = limit("-1", "2", "80", "11")


def symmetric_pairs(left: str, right: str, kind: str = "revolute", other: str = "revolute") -> str:
    return robot(joint("left_arm", kind, left), joint("right_arm", other, right))


@pytest.mark.parametrize(
    ("right", "difference"),
    [
        (limit("-1", "2", "1000", "11"), "effort 1000, not 80 N·m"),
        (limit("-1", "2", "81", "11"), "effort 81, not 80 N·m"),
        (limit("-1", "2", "80", "5"), "velocity 5, not 11 rad/s"),
        (limit("-1", "1.5", "80", "11"), "limits [-1, 1.5], not [-1, 2] rad"),
        (limit("-1.2", "2.2", "80", "11"), "limits [-1.2, 2.2], not [-1, 2] rad"),
        (
            limit("0", "2", "1", "2"),
            "effort 1, not 80 N·m, velocity 2, not 11 rad/s, limits [0, 2], not [-1, 2] rad",
        ),
    ],
)
def test_what_differs(right: str, difference: str) -> None:
    text = symmetric_pairs(REVOLUTE, right)
    (found,) = reported("JNT025", text)
    assert found.message == naming("right_arm", "left_arm", difference)
    assert found.confidence is Confidence.INFERRED
    assert places("JNT025", text) == [(6, right)]
    assert [other.message for other in found.related] == ["counterpart 'left_arm'"]


def test_another_type() -> None:
    text = symmetric_pairs(REVOLUTE, limit("-1", "2"), other="continuous")
    assert messages("JNT025", text) == [naming("right_arm", "left_arm", "continuous", "revolute")]
    assert places("JNT025", text) == [(6, '<joint name="right_arm" type="continuous">')]


@pytest.mark.parametrize(
    ("left", "right"),
    [
        (REVOLUTE, REVOLUTE),
        (REVOLUTE, limit("-2", "1", "80", "11")),  # mirrored
        (REVOLUTE, limit("-1.1", "2.1", "80.4", "11.05")),
        # the ankle of a NAO
        (
            limit("-1.189442", "0.922581", "3.023", "6.4"),
            limit("-1.1863", "0.932006", "3.0226", "6.4"),
        ),
        (REVOLUTE, limit("-1", "2", "0", "0")),  # JNT008
        (REVOLUTE, limit("0", "0", "80", "11")),  # JNT003
        (REVOLUTE, limit("-1", "2", "-80", "11")),  # JNT008
        (REVOLUTE, ""),  # JNT002
        (REVOLUTE, limit("x", "2", "x", "11")),  # URD005
    ],
)
def test_no_finding(left: str, right: str) -> None:
    assert reported("JNT025", symmetric_pairs(left, right)) == []


def test_wheels_of_which_one_has_no_limit_are_left_to_another_rule() -> None:
    wheel = '<limit effort="100" velocity="100"/>'
    assert reported("JNT025", symmetric_pairs("", wheel, "continuous", "continuous")) == []


def test_axes_of_one_arm_are_no_counterparts() -> None:
    first = joint("joint_l", "revolute", limit("-1", "2", "6000", "2"))
    second = joint("joint_r", "revolute", limit("-3", "3", "700", "3"), parent="joint_l_link")
    assert reported("JNT025", robot(first, second)) == []


def numbered(*origins: str) -> str:
    return robot(
        *(
            joint(
                f"wheel_{number}",
                "continuous",
                f'<origin xyz="{xyz}"/><limit effort="{number}" velocity="1"/>',
            )
            for number, xyz in enumerate(origins, 1)
        )
    )


def test_numbered_joints_are_counterparts_if_they_lie_mirrored() -> None:
    assert messages("JNT025", numbered("0.1 0.2 0", "0.1 -0.2 0")) == [
        naming("wheel_2", "wheel_1", "effort", "2", "1 N·m")
    ]
    assert reported("JNT025", numbered("0.1 0.2 0", "0.1 -0.25 0")) == []
    assert reported("JNT025", numbered("0 0 0.1", "0 0 0.2")) == []


def test_no_tree() -> None:
    text = symmetric_pairs(REVOLUTE, limit("-1", "2", "1", "11"))
    assert reported("JNT025", text.replace('<parent link="base"/>', '<parent link="z"/>')) == []
    assert reported("JNT025", text.replace('<parent link="base"/>', "")) == []
    loop = text.replace('<parent link="base"/>', '<parent link="left_arm_link"/>')
    assert reported("JNT025", loop) == []


LOSSES = '<dynamics damping="{}" friction="{}"/>'


@pytest.mark.parametrize(
    ("losses", "difference"),
    [
        ((5, 0.2), "damping 5, not 0.5 N·m·s/rad"),
        ((0.5, 0.02), "friction 0.02, not 0.2 N·m"),
        ((0.4, 0.3), ""),  # they are measured
        ((0, 0.2), ""),
    ],
)
def test_damping_and_friction(losses: tuple[float, float], difference: str) -> None:
    robot = symmetric_pairs(REVOLUTE + LOSSES.format(0.5, 0.2), REVOLUTE + LOSSES.format(*losses))
    expected = [naming("right_arm", "left_arm", difference)] if difference else []
    assert messages("JNT025", robot) == expected


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
    assert messages("JNT025", corners("-0.2")) == []  # longer, but to the right


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


def test_the_same_place_as_the_other_side_with_its_rotation() -> None:
    front = PART.format(side="front_left", xyz="1 1 0", rpy="0 0 0")
    front += PART.format(side="front_right", xyz="1 -1 0", rpy="3.14 0 0")
    rear = PART.format(side="rear_left", xyz="-1 1 0", rpy="0 0 0")
    for xyz, count in (("-1 1 0", 1), ("-1 -1 0", 0)):
        other = PART.format(side="rear_right", xyz=xyz, rpy="3.14 0 0")
        text = f'<link name="base"/>{front}{rear}{other}'
        assert sum("same place" in one for one in messages("JNT025", text)) == count


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


#: A leg of the Mini Pupper: hip, knee and foot, with a mesh for each side.
LEG = """\
<joint name="base_{0}1" type="revolute"><parent link="base"/><child link="{0}1"/>
<origin xyz="{1} {2}0.02 0"/><axis xyz="1 0 0"/><limit {3} effort="20" velocity="1"/></joint>
<joint name="{0}1_{0}2" type="revolute"><parent link="{0}1"/><child link="{0}2"/>
<origin xyz="0 {2}0.005 -0.05"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="-0.2" effort="20" velocity="1"/></joint>
<joint name="{0}2_foot" type="fixed"><parent link="{0}2"/><child link="{0}foot"/>
<origin xyz="0 0 -0.056"/></joint>
<link name="{0}1"/><link name="{0}2"><visual><geometry><mesh filename="{0}2.stl"/></geometry>
</visual></link><link name="{0}foot"/>
"""
OUTWARDS = {"": 'lower="-0.5" upper="0.4"', "-": 'lower="-0.4" upper="0.5"'}


def quadruped() -> str:
    legs = {"lf": ("0.1", ""), "rf": ("0.1", "-"), "rb": ("-0.1", "-"), "lb": ("-0.1", "")}
    return '<link name="base"/>' + "".join(
        LEG.format(leg, x, side, OUTWARDS[side]) for leg, (x, side) in legs.items()
    )


@pytest.mark.parametrize(
    ("after", "old", "new", "expected"),
    [
        (
            "base_rb1",
            OUTWARDS["-"],
            OUTWARDS[""],
            naming("base_rb1", "base_lb1", "[-0.4, 0.5] rad"),
        ),
        ("rb1_rb2", "0 -0.005 ", "0 0.005 ", naming("rb1_rb2", "0.01 m", "left", "lb1_lb2")),
        ("rf1_rf2", 'effort="20"', 'effort="2"', naming("rf1_rf2", "lf1_lf2", "2", "20 N·m")),
        ("rf1_rf2", "0 1 0", "0 -1 0", naming("rf1_rf2", "lf1_lf2", "[0.2, 2] rad")),
        ("lb2_foot", "-0.056", "-0.065", naming("lb2_foot", "0.009 m", "down", "rb2_foot")),
        ("lb1_lb2", 'link="lb1"', 'link="lf1"', naming("lb1_lb2", "lf1", "rb1_rb2", "rb1")),
    ],
)
def test_one_leg_of_four(after: str, old: str, new: str, expected: str) -> None:
    """Mangdang's Mini Pupper: each joint has the side twice in its name."""
    assert messages("JNT025", quadruped()) == []
    before, name, leg = quadruped().partition(f'name="{after}"')
    assert messages("JNT025", before + name + leg.replace(old, new, 1)) == [expected]


def test_legs_of_which_one_is_turned() -> None:
    """PAL's Kangaroo: the same origin in shoulders of which one is turned by half a turn."""
    assert messages("JNT025", quadruped()) == []
    text = quadruped().replace('xyz="-0.1 -0.02 0"', 'xyz="-0.1 -0.02 0" rpy="3.14159 0 3.14159"')
    before, name, leg = text.partition('name="rb1_rb2"')
    turned = before + name + leg.replace("0 -0.005 -0.05", "0.01 0.005 -0.05", 1)
    before, name, leg = turned.partition('name="lb1_lb2"')
    turned = before + name + leg.replace("0 0.005 -0.05", "0.01 0.005 -0.05", 1)
    assert not any("rb1_rb2" in message for message in messages("JNT025", turned))


def test_two_cameras_of_one_product() -> None:
    """Galaxea's R1: the lens of each is beside its middle, to the same side."""
    text = quadruped()
    for side in ("lf", "rf"):
        text += (
            f'<joint name="{side}2_camera" type="fixed"><parent link="{side}2"/>'
            f'<child link="{side}_camera"/><origin xyz="0 0.0042 0"/></joint>'
            f'<link name="{side}_camera"><visual><geometry><mesh filename="{side}_camera.stl"/>'
            "</geometry></visual></link>"
        )
    assert messages("JNT025", text) == []

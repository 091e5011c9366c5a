import pytest

from tests.gazebos import BASE, BODY, WHEELS, block, child, plugin, sensor
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Severity

STATES = "libgazebo_ros_joint_state_publisher.so"
P3D = "libgazebo_ros_p3d.so"
HAND = "libgazebo_ros_hand_of_god.so"
FORCE = "libgazebo_ros_ft_sensor.so"
KEEP = '<gazebo reference="tool_joint">\n  <preserveFixedJoint>true</preserveFixedJoint>\n</gazebo>'


def states(joints: str) -> str:
    return WHEELS + plugin(STATES, f"<jointName>{joints}</jointName>")


def pose(body: str, frame: str = "world") -> str:
    tags = f"<topicName>t</topicName><bodyName>{body}</bodyName><frameName>{frame}</frameName>"
    return BASE + plugin(P3D, tags)


def hand(link: str = "tool", inside: str = BODY) -> str:
    return (
        BASE + child("tool", "fixed", inside=inside) + plugin(HAND, f"<linkName>{link}</linkName>")
    )


def test_a_link_that_does_not_exist() -> None:
    (found,) = reported("GAZ021", pose("baase"))
    assert found.message == naming("p", P3D, "unknown", "baase")
    assert found.help == naming("base")
    assert places("GAZ021", pose("baase")) == [(4, "<bodyName>")]
    assert "<bodyName>base<" in fixed("GAZ021", pose("baase"))


def test_every_name_of_a_list() -> None:
    heard = messages("GAZ021", states("left_joint, rihgt_joint,spare"))
    assert [one.split("'")[3] for one in heard] == ["rihgt_joint", "spare"]


def test_a_list_where_one_name_counts() -> None:
    """A rover with six wheels, whose plugin drives one joint on each side."""
    tag = "<leftJoint>left_joint, right_joint</leftJoint><rightJoint>right_joint</rightJoint>"
    (found,) = reported("GAZ021", WHEELS + plugin("libgazebo_ros_diff_drive.so", tag))
    assert found.help == naming("<leftJoint>")


def test_the_name_of_a_link_is_not_a_joint() -> None:
    assert len(reported("GAZ021", states("left"))) == 1


def test_an_attribute() -> None:
    mistake = '<wheel link_name="whel"><wheel_normal_force>1</wheel_normal_force></wheel>'
    assert places("GAZ021", BASE + plugin("libWheelSlipPlugin.so", mistake)) == [(4, "whel")]


@pytest.mark.parametrize("frame", ["world", "/world", "map", "/map", "base", "robot::base"])
def test_frames_that_need_no_link(frame: str) -> None:
    assert reported("GAZ021", pose("base", frame)) == []


@pytest.mark.parametrize(
    "text",
    [
        states("left_joint, right_joint"),
        states("spare") + '<gazebo><joint name="spare" type="revolute"/></gazebo>',
        pose("extra") + '<gazebo><link name="extra"/></gazebo>',
        BASE + plugin("libgazebo_ros_planar_move.so", "<robotBaseFrame>any</robotBaseFrame>"),
        BASE + plugin("libvendor.so", "<bodyName>extra</bodyName>"),
        hand("base"),
        hand().replace('type="fixed"', 'type="continuous"'),
        BASE + child("arm") + plugin(STATES, "<jointName>arm_joint</jointName>"),
    ],
)
def test_names_that_exist_or_are_not_looked_up(text: str) -> None:
    assert reported("GAZ021", text) == []


def test_the_remaining_link_is_named() -> None:
    (found,) = reported("GAZ021", hand())
    assert found.message == naming("p", HAND, "tool", "Gazebo", "base")
    assert found.help == naming("base", "tool_joint", "<preserveFixedJoint>")


def test_the_fix_keeps_the_joint_and_helps() -> None:
    text = fixed("GAZ021", hand())
    assert KEEP in text
    assert reported("GAZ021", text.encode()) == []


def test_a_link_without_mass_cannot_be_kept() -> None:
    (found,) = reported("GAZ021", hand(inside=""))
    assert found.fix is None
    assert found.help == "name 'base'"


def test_a_fixed_joint_is_merged_too() -> None:
    tags = "<topicName>t</topicName><jointName>tool_joint</jointName>"
    text = BASE + child("tool", "fixed") + plugin(FORCE, tags)
    (message,) = messages("GAZ021", text)
    assert "into link 'base'" in message
    assert reported("GAZ021", fixed("GAZ021", text).encode()) == []


@pytest.mark.parametrize("tag", ["preserveFixedJoint", "disableFixedJointLumping"])
def test_a_joint_that_is_kept(tag: str) -> None:
    assert reported("GAZ021", hand() + block(f"<{tag}>true</{tag}>", "tool_joint")) == []


def test_the_converter_rewrites_two_names_in_plugins_of_the_model() -> None:
    tags = "<topicName>t</topicName><bodyName>tool</bodyName><frameName>tool</frameName>"
    text = BASE + child("tool", "fixed") + plugin(P3D, tags)
    assert reported("GAZ021", text) == []


def test_a_frame_id_need_not_exist_in_gazebo() -> None:
    tags = "<topicName>t</topicName><frameName>tool</frameName><bodyName>tool</bodyName>"
    imu = f'<plugin name="p" filename="libgazebo_ros_imu_sensor.so">{tags}</plugin>'
    assert reported("GAZ021", BASE + child("tool", "fixed") + sensor("imu", imu, "tool")) == []


def test_no_state_is_needed_of_a_fixed_joint() -> None:
    text = BASE + child("tool", "fixed") + plugin(STATES, "<joint_name>tool_joint</joint_name>")
    assert messages("GAZ021", text) == []


def test_a_link_that_is_dropped() -> None:
    text = BASE + child("arm", inside="") + plugin(HAND, "<linkName>arm</linkName>")
    (found,) = reported("GAZ021", text)
    assert found.message == naming("p", HAND, "arm", "Gazebo", "arm", "inertial")
    assert found.help == naming("arm", "<inertial>")


def test_the_child_of_a_dropped_link_is_dropped() -> None:
    robot = BASE + child("arm", inside="") + child("hand", parent="arm")
    (message,) = messages("GAZ021", robot + plugin(STATES, "<jointName>hand_joint</jointName>"))
    assert "drops (link 'hand'" in message


def test_a_plugin_that_only_another_gazebo_loads() -> None:
    tags = "<joint>left_joint</joint><mimicJoint>{}</mimicJoint>"
    file = "libroboticsgroup_gazebo_mimic_joint_plugin.so"
    text = WHEELS + plugin(file, tags.format("rihgt_joint"))
    for target, severity in (("classic-ros1", Severity.ERROR), ("classic-ros2", Severity.WARNING)):
        (found,) = reported("GAZ021", text, targets=(target,))
        assert found.severity is severity
        assert found.message.startswith(f"plugin 'p' ({file}) refers to unknown joint")
        right = WHEELS + plugin(file, tags.format("right_joint"))
        assert reported("GAZ021", right, targets=(target,)) == []

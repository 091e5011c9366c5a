import pytest

from tests.gazebos import BASE, child, plugin
from tests.naming import naming
from tests.reported import messages, reported

JOINT = "<joint_name>arm_joint</joint_name>"
ARM = BASE + child("arm")
MOTOR = plugin("gz-sim-joint-controller-system", JOINT)
CONTROL = plugin("gz_ros2_control-system", "<parameters>c.yaml</parameters>")
INTERFACE = (
    '<ros2_control name="c" type="system"><joint name="arm_joint">'
    '<command_interface name="velocity"/></joint></ros2_control>'
)
TRANSMISSION = '<transmission name="t"><joint name="arm_joint"/></transmission>'


def test_two_plugins() -> None:
    other = plugin("gz-sim-apply-joint-force-system", JOINT, name="q")
    (message,) = messages("GAZ028", ARM + MOTOR + other)
    assert message == naming(
        "arm_joint", "q", "gz-sim-apply-joint-force-system", "p", "gz-sim-joint-controller-system"
    )


def test_beside_ros2_control() -> None:
    (found,) = reported("GAZ028", ARM + INTERFACE + CONTROL + MOTOR)
    assert found.message.endswith("and by <ros2_control>")
    assert [note.span.text for note in found.related] == ['<joint name="arm_joint">']


def test_beside_a_transmission() -> None:
    mimic = "<joint>base_joint</joint><mimicJoint>arm_joint</mimicJoint>"
    motor = plugin("libroboticsgroup_upatras_gazebo_mimic_joint_plugin.so", mimic)
    text = ARM + TRANSMISSION + plugin("libgazebo_ros_control.so") + motor
    (found,) = reported("GAZ028", text)
    assert found.message == naming(
        "arm_joint", "p", "libroboticsgroup_upatras_gazebo_mimic_joint_plugin.so", "<transmission>"
    )


@pytest.mark.parametrize(
    "text",
    [
        MOTOR,
        INTERFACE + MOTOR,  # nothing in Gazebo reads it
        TRANSMISSION + MOTOR,
        INTERFACE.replace("command_interface", "state_interface") + CONTROL + MOTOR,
        MOTOR + plugin("gz-sim-joint-state-publisher-system", JOINT),  # reads only
    ],
)
def test_driven_once(text: str) -> None:
    assert reported("GAZ028", ARM + text) == []


@pytest.mark.parametrize(
    ("number", "topic", "count"), [("1", "speed", 0), ("0", "speed", 1), ("0", "tilt", 0)]
)
def test_motors_of_a_drone(number: str, topic: str, count: int) -> None:
    def motor(joint: str, number: str, topic: str) -> str:
        tags = (
            f"<jointName>{joint}_joint</jointName><linkName>{joint}</linkName>"
            f"<commandSubTopic>{topic}</commandSubTopic><actuator_number>{number}</actuator_number>"
        )
        return plugin("gz-sim-multicopter-motor-model-system", tags, name=joint)

    drone = BASE + child("front") + child("rear")
    found = messages("GAZ028", drone + motor("front", "0", "speed") + motor("rear", number, topic))
    assert [
        one == naming("front_joint", "rear_joint", "actuator_number", "0") for one in found
    ] == [True] * count

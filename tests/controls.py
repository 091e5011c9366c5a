"""Pieces of robots under control, for the tests of the rules RCT."""

from pathlib import Path

from tests.jointed import joint, limit, mimic, robot
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot

#: Joints: 'swing' without end, 'slide' of 0 to 0.5 m, 'weld' fixed, 'follow' after 'swing'.
ROBOT = robot(
    joint("swing", "continuous", limit("0", "0", "10", "2")),
    joint("slide", "prismatic", limit("0", "0.5", "100", "0.2")),
    joint("weld", "fixed"),
    joint("follow", "continuous", mimic("swing")),
)
#: The line on which what stands behind ROBOT begins.
NEXT = 3 + 2 * 4

MOCK = "mock_components/GenericSystem"
CLASSIC = "gazebo_ros2_control/GazeboSystem"
GZ = "gz_ros2_control/GazeboSimSystem"
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"


def control(*parts: str, plugin: str = MOCK, name: str = "c", kind: str = "system") -> str:
    """A ``<ros2_control>`` on as many lines as it has parts, and two more."""
    return "\n".join(
        [
            f'<ros2_control name="{name}" type="{kind}">',
            f"<hardware><plugin>{plugin}</plugin></hardware>",
            *parts,
            "</ros2_control>\n",
        ]
    )


def driven(name: str, command: str = "position", state: str = "position", more: str = "") -> str:
    """A joint of it, on one line."""
    return (
        f'<joint name="{name}">{more}<command_interface name="{command}"/>'
        f'<state_interface name="{state}"/></joint>'
    )


def transmission(
    joint_name: str, interface: str = "hardware_interface/EffortJointInterface"
) -> str:
    """A transmission of ROS 1, on two lines."""
    return (
        '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>\n'
        f'<joint name="{joint_name}"><hardwareInterface>{interface}</hardwareInterface></joint>'
        '<actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator>'
        "</transmission>\n"
    )


def plugin(filename: str, content: str = "") -> str:
    """A plugin of Gazebo, on one line."""
    return f'<gazebo><plugin name="p" filename="{filename}">{content}</plugin></gazebo>\n'


def controller(name: str, kind: str = TRAJECTORY, **parameters: str) -> str:
    """A controller; its parameters begin on the fourth line."""
    lines = "".join(f"    {key}: {value}\n" for key, value in parameters.items())
    return f"{name}:\n  ros__parameters:\n    type: {kind}\n{lines}"


def reported_with_file(
    code: str, directory: Path, text: str, blocks: str, robot: str = ROBOT, more: str = ""
) -> list[Diagnostic]:
    """What a rule says of a robot and a parameter file, ``c.yaml``, that its plugin names.

    Args:
        text: of the parameter file.
        blocks: behind the robot.
        more: further tags of the plugin.
    """
    (directory / "c.yaml").write_text(text)
    names = plugin("gz_ros2_control-system", f"{more}<parameters>{directory}/c.yaml</parameters>")
    (directory / "r.urdf").write_text(whole_robot(robot + blocks + names))
    report = check(directory / "r.urdf", select=[code])
    assert report.crashed == ()
    return list(report.diagnostics)

"""`<ros2_control>` or a transmission drives a joint that cannot be driven: fixed, or a mimic joint.

- A fixed joint cannot move. From ROS 2 Jazzy on, the controller manager throws an exception. In
  Gazebo the joint does not exist, because its links are merged, and gazebo_ros_control of ROS 1
  drives no joint at all. Without Gazebo, a transmission of a fixed joint is a warning: the real
  wheels of a robot may be fixed in its model. Transmissions of the PR2, and those with a vendor's
  interface, are not reported.
- A mimic joint with its own command interface stops the controller manager from Jazzy on:
  "Activated mimic joints cannot have command interfaces". Humble does not read `<mimic>` here, and
  a controller moves the joint independently. Keep only state interfaces, or write `mimic="false"`
  in this joint of `<ros2_control>` if it has its own motor.
- `<param name="mimic">` and `<param name="multiplier">` couple joints in a simulator in Humble and
  Iron. From Jazzy on they are ignored (warning): write `<mimic>` into the joint of the URDF.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, joints: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joints_userdoc.rst
    ros2_control#1553: https://github.com/ros-controls/ros2_control/pull/1553
    gz_ros2_control#340: https://github.com/ros-controls/gz_ros2_control/issues/340
    gazebo_ros_control_plugin.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/gazebo_ros_control_plugin.cpp
"""

from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import arm_xml, robot_xml
from urdfkit.ros.catalog import ros_control
from urdfkit.ros.gazebo.samples import control_xml, driven_xml
from urdfkit.ros.ros_control import (
    ROS1,
    ROS2,
    ControlPart,
    components,
    is_of_pr2,
    joints_and_owners,
    parameter,
)
from urdfkit.text.document import Element

BAD = robot_xml(
    arm_xml("fixed"), control_xml("mock_components/GenericSystem", driven_xml("shoulder"))
)
GOOD = BAD.replace('type="fixed"', 'type="continuous"')

#: Gazebo with ROS 2 Humble, and with Jazzy or newer.
_HUMBLE, _JAZZY = ("classic-ros2", "gz-fortress"), ("gz-harmonic", "gz-jetty")


@rule(Severity.WARNING, by_target=dict.fromkeys((*ROS1, *ROS2), Severity.ERROR))
def check(context: Context) -> Findings:
    yield from _fixed(context)
    targets = context.targets
    is_jazzy = targets.any_of(_JAZZY) and not targets.any_of(_HUMBLE)
    for component in components(context.model):
        for part in component.joints:
            joint = context.model.joints_by_name.get(part.name)
            if joint and joint.mimic:
                yield from _commanded_mimic(part, joint.leader, targets.among(_HUMBLE), is_jazzy)
            elif joint and is_jazzy and (leader_at := parameter(part.at, "mimic")):
                yield Finding(
                    leader_at,
                    f"joint '{part.name}' mimics '{leader_at.text.strip()}' by a parameter, which "
                    "ros2_control ignores from Jazzy on",
                    "add <mimic> to the joint of the URDF",
                    confidence=Confidence.INFERRED,
                    severity=Severity.WARNING,
                )


def _fixed(context: Context) -> Findings:
    joints = context.model.joints_by_name
    for element, owner in joints_and_owners(context):
        joint = joints.get(element.get("name") or "")
        if joint and joint.kind == "fixed" and not _has_other_reader(element):
            is_transmission = element.parent is not None and element.parent.tag == "transmission"
            is_unread = is_transmission and "classic-ros1" not in context.targets.names
            message = f"{owner} has joint '{joint.name}', which is fixed"
            help = "change the type of the joint, or remove the joint here"
            severity = Severity.WARNING if is_unread else None
            at = element.attributes["name"]
            yield Finding(at, message, help, group_key="fixed", severity=severity)


def _has_other_reader(joint: Element) -> bool:
    """True if a transmission is the PR2's, or has only hardware interfaces unknown to ROS."""
    if joint.parent is not None and is_of_pr2(joint.parent):
        return True
    known = {name.rpartition("/")[2] for name in ros_control.words("transmission", "interfaces")}
    names = {element.text.strip().rpartition("/")[2] for element in joint.all("hardwareInterface")}
    return bool(names) and names.isdisjoint(known)


def _commanded_mimic(
    part: ControlPart, leader: str, humble: tuple[str, ...], is_jazzy: bool
) -> Findings:
    """A mimic joint with a command interface; Humble allows it with its ``mimic`` parameter."""
    commands = part.of("command")
    has_motor = (part.at.get("mimic") or "").lower() == "false"
    is_of_humble = parameter(part.at, "mimic") is not None and not is_jazzy
    if commands and not has_motor and not is_of_humble:
        yield Finding(
            commands[0].at,
            f"mimic joint '{part.name}' (of '{leader}') has command interface '{commands[0].name}'",
            'delete the command interface, or write mimic="false" in this joint of <ros2_control>',
            severity=Severity.WARNING if humble else Severity.ERROR,
            targets=humble,
            group_key="mimic",
        )

"""Two plugins drive the same joint.

Both write its velocity or force in every step: the last write wins, or the commands conflict. Usual
pairs are a drive plugin next to ros2_control, or next to the transmissions of
`libgazebo_ros_control.so`.

Two motors of a drone with the same number on one topic execute the same command, and the drone tips
over.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.gazebo.drives import driven
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import ARM, gazebo_xml, plugin_xml
from urdfkit.text.document import Element

_JOINT = "<joint_name>shoulder</joint_name>"
BAD = ARM + gazebo_xml(
    plugin_xml("gz::sim::systems::JointController", "gz-sim-joint-controller-system", _JOINT),
    plugin_xml("gz::sim::systems::ApplyJointForce", "gz-sim-apply-joint-force-system", _JOINT),
)
GOOD = BAD[: BAD.index('  <plugin name="gz::sim::systems::ApplyJointForce"')] + "</gazebo>"

#: What a motor of gz-sim or RotorS has: its number, and what is before it.
_NUMBERS = ("actuator_number", "motorNumber")
_TOPICS = ("robotNamespace", "commandSubTopic", "motorType")


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO), help="let one of them drive it")
def check(context: Context) -> Findings:
    drivers = _controlled(context)
    for use in context.plugins:
        for reference in driven(use):
            title, at = drivers.setdefault(reference.name, (use.title, use.at))
            if at is not use.at:
                yield Finding(
                    reference.item.at,
                    f"joint '{reference.name}' is driven by {use.title} and by {title}",
                    related=(Related(at.span, "also driven here"),),
                )
    yield from _motors(context)


def _motors(context: Context) -> Findings:
    """The motors of a drone that have the number of another motor."""
    first: dict[tuple[str, ...], PluginUse] = {}
    for use in context.plugins:
        number = next((use.at.child(tag) for tag in _NUMBERS if use.at.child(tag)), None)
        if number is None or not number.text.strip():
            continue
        key = (*(use.value(name) for name in _TOPICS), number.text.strip())
        other = first.setdefault(key, use)
        joints = [plugin.value("jointName") for plugin in (other, use)]
        if other is not use and joints[0] != joints[1]:
            yield Finding(
                number,
                f"the motors of '{joints[0]}' and '{joints[1]}' have the same {number.tag}, "
                f"{number.text.strip()}, and follow one command",
                "give each motor a number of its own, from 0",
                related=(Related(other.at.span, f"the motor of '{joints[0]}'"),),
            )


def _controlled(context: Context) -> dict[str, tuple[str, Element]]:
    """The joints that ros2_control or gazebo_ros_control commands, each with its controller."""
    found: dict[str, tuple[str, Element]] = {}
    names = " ".join(use.filename for use in context.plugins)
    for control in context.model.ros2_controls if "ros2_control" in names else ():
        for joint in control.all("joint"):
            if joint.child("command_interface"):
                found[joint.get("name") or ""] = ("<ros2_control>", joint)
    if "gazebo_ros_control" in names:
        for transmission in context.model.transmissions:
            for joint in transmission.all("joint"):
                found[joint.get("name") or ""] = ("a <transmission>", transmission)
    return found

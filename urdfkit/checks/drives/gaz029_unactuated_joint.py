"""No plugin, transmission or ros2_control drives a joint of a robot that has Gazebo plugins.

In Gazebo a joint that nothing drives swings or rolls freely. That may be intended, as with a plugin
that slides the whole robot over the ground; the wheels then turn only as friction turns them.

Sources:
    gz_ros2_control: https://github.com/ros-controls/gz_ros2_control/blob/rolling/doc/index.rst
    Gazebo Classic, plugins: https://classic.gazebosim.org/tutorials?tut=ros_gzplugins
"""

from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.samples import element_xml, robot_xml
from urdfkit.ros.gazebo.drives import driven
from urdfkit.ros.gazebo.samples import ARM, gazebo_xml, plugin_xml

BAD = ARM + gazebo_xml(
    plugin_xml("drive", "libgazebo_ros_planar_move.so", "<robotBaseFrame>base</robotBaseFrame>")
)
_INTERFACE = "<hardwareInterface>hardware_interface/VelocityJointInterface</hardwareInterface>"
GOOD = robot_xml(
    BAD,
    element_xml(
        'transmission name="shoulder_transmission"',
        "<type>transmission_interface/SimpleTransmission</type>",
        element_xml('joint name="shoulder"', _INTERFACE),
        '<actuator name="shoulder_motor"/>',
    ),
)

#: Number of names in a message; the others are counted.
_MAX_NAMED = 4


@rule(
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="add a drive plugin or ros2_control, unless they are intended to turn freely",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    model = context.model
    if model.transmissions or model.ros2_controls or not context.plugins or context.is_part:
        return
    if any(use.plugin is None or _moves_joints(use.plugin.id) for use in context.plugins):
        return  # a vendor's plugin may drive them
    if any(driven(use) for use in context.plugins):
        return
    wheels = [joint for joint in model.joints if joint.kind == "continuous" and not joint.mimic]
    if not wheels:
        return
    names = few([f"'{joint.name}'" for joint in wheels], _MAX_NAMED)
    who, verb, them = ("joints", "are", "them") if len(wheels) > 1 else ("joint", "is", "it")
    yield Finding(
        wheels[0].at,
        f"{who} {names} {verb} not actuated in Gazebo: no transmission, ros2_control or "
        f"plugin names {them}",
        related=tuple(
            Related(joint.at.span, "not actuated either") for joint in wheels[1:_MAX_NAMED]
        ),
    )


def _moves_joints(identity: str) -> bool:
    """True for a plugin that moves joints without naming them."""
    words = ("control", "Drive", "trajectory", "mavlink", "elevator", "gripper", "Tracked")
    return any(word in identity for word in words)

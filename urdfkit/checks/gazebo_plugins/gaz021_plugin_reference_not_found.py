"""A plugin refers to a link or joint that does not exist in the simulation.

The plugin searches for the name in the simulated model; if it is not found, the plugin writes an
error and stays idle, and some plugins stop the simulator. There are three causes:

- The robot has no such link or joint. Xacro prefixes are a usual reason.
- Gazebo merged it: all links that fixed joints connect become one, and only the topmost keeps its
  name. Name the link that remains, or keep the joint with
  `<preserveFixedJoint>true</preserveFixedJoint>` in a `<gazebo>` block that refers to it; the link
  then needs a mass of its own.
- Gazebo dropped it: a link without mass that no fixed joint merges into another is not simulated,
  and neither are the links below it. Give the link an `<inertial>`.

A warning for a plugin that only another Gazebo loads.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/sdformat#199: https://github.com/gazebosim/sdformat/issues/199
    gazebosim/gazebo-classic#2732: https://github.com/gazebosim/gazebo-classic/issues/2732
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    ros-simulation/gazebo_ros_pkgs#609: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/609
    ros-simulation/gazebo_ros_pkgs#843: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/843
    osrf/vrx#867: https://github.com/osrf/vrx/issues/867
"""

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.ros.catalog.extensions import rewritten
from urdfkit.ros.gazebo.plugins import PluginUse, Reference, conversion_result
from urdfkit.ros.gazebo.samples import ARM, gazebo_xml, plugin_xml
from urdfkit.text.editing.edits import fix_value, from_macro, insert_before

_JOINT = "<jointName>sholder</jointName>"
BAD = ARM + gazebo_xml(plugin_xml("states", "libgazebo_ros_joint_state_publisher.so", _JOINT))
FIXED = GOOD = BAD.replace("sholder", "shoulder")

#: They leave out a joint that is not there; robot_state_publisher needs no state of a fixed one.
_STATES = (
    "gazebo_ros_joint_state_publisher@classic-ros2",
    "gz-sim-joint-state-publisher-system@gz",
)


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="name a link or joint of this robot",
    reports_missing=True,
)
def check(context: Context) -> Findings:
    conversion = context.gazebo
    suggesters = {
        "link": Suggester(context.model.links_by_name),
        "joint": Suggester(context.model.joints_by_name),
    }
    for use in context.plugins:
        for reference in use.references():
            result = conversion_result(conversion, reference.kind, reference.name)
            is_world = reference.kind == "link" and reference.name == "world"
            if result == "unknown" and not is_world and not context.is_part:
                yield _unknown(context, use, reference, suggesters[reference.kind])
            elif use.plugin is None:
                continue  # of another Gazebo, which may convert the robot in another way
            elif result == "merged" and not _is_rewritten(use, reference):
                yield _merged(context, use, reference)
            elif result == "dropped" and not context.is_part:
                yield _dropped(context, use, reference)


def _unknown(
    context: Context, use: PluginUse, reference: Reference, suggester: Suggester
) -> Finding:
    item, name = reference.item, reference.name
    suggested = suggester.suggested(name)
    fix = fix_value(item.at, suggested) if item.text == name else None
    message = f"{use.title} refers to unknown {reference.kind} '{name}'{use.outcome}"
    help = f"did you mean '{suggested}'?" if suggested else f"name a {reference.kind} of this robot"
    words, model = name.replace(",", " ").split(), context.model
    is_still = all(joint.kind == "fixed" for joint in model.joints)
    if reference.kind == "joint" and is_still and not suggested:
        help = "add the joint: no joint of this robot moves"
    names = model.links_by_name if reference.kind == "link" else model.joints_by_name
    if len(words) > 1 and any(word in names for word in words):
        tag = item.path.rpartition("/")[2]
        help = f"name one in each <{tag}>, which does not take several {reference.kind}s"
    severity = None if use.plugin else Severity.WARNING
    return Finding(item.at, message, help, fix, severity=severity)


def _is_rewritten(use: PluginUse, reference: Reference) -> bool:
    """True if the converter writes the remaining link there, or the plugin does not need it."""
    if use.place == "model" and reference.parameter.name in rewritten():
        return True
    return use.plugin is not None and use.plugin.id in _STATES


def _merged(context: Context, use: PluginUse, reference: Reference) -> Finding:
    joint = _fixed_joint(context, reference)
    child = joint.child_name if joint and joint.child else reference.name
    survivor = context.gazebo.survivor.get(child, "")
    can_keep = joint is not None and context.model.links_by_name[child].mass > 0
    help = f"name '{survivor}'" if reference.kind == "link" else "make it a joint that moves"
    if joint and can_keep:
        help += f", or keep joint '{joint.name}' with <preserveFixedJoint>"
    message = (
        f"{use.title} refers to {reference.kind} '{reference.name}', which Gazebo merges into "
        f"link '{survivor}'{use.outcome}"
    )
    fix = _kept(use, joint) if joint and can_keep else None
    return Finding(reference.item.at, message, help, fix, group_key=use.filename)


def _fixed_joint(context: Context, reference: Reference) -> Joint | None:
    if reference.kind == "joint":
        return context.model.joints_by_name[reference.name]
    above = context.tree.parents[reference.name]
    return above[0] if len(above) == 1 else None


def _kept(use: PluginUse, joint: Joint) -> Fix | None:
    if from_macro(use.block):  # the name would be that of one call
        return None
    lines = (
        f'<gazebo reference="{joint.name}">',
        "  <preserveFixedJoint>true</preserveFixedJoint>",
        "</gazebo>",
    )
    return Fix(f"keep joint '{joint.name}' in Gazebo", insert_before(use.block, lines))


def _dropped(context: Context, use: PluginUse, reference: Reference) -> Finding:
    link = reference.name
    if reference.kind == "joint":
        child = context.model.joints_by_name[reference.name].child
        link = child.value if child else link
    reason = context.gazebo.dropped[link]
    return Finding(
        reference.item.at,
        f"{use.title} refers to {reference.kind} '{reference.name}', which Gazebo drops "
        f"(link '{link}': {reason}){use.outcome}",
        f"give link '{link}' an <inertial> with its mass",
        group_key=reason,
    )

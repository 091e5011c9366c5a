"""A required parameter of a plugin is missing.

Some tags have no default, or a default joint that this robot does not have: the plugin writes an
error and stays idle, and some plugins stop the whole simulator. A tag with an argument of the xacro
that is empty by default is not reported. The same holds for drives with another number of wheels
than that of `<num_wheel_pairs>`. gazebo_ros2_control of Gazebo Classic runs without `<parameters>`,
as a spawner can set the types of the controllers (warning).

Sources:
    gazebo_ros_diff_drive.cpp of ROS 1: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    gz-sim, DiffDrive.cc: https://github.com/gazebosim/gz-sim/blob/main/src/systems/diff_drive/DiffDrive.cc
    ros-simulation/gazebo_ros_pkgs#609: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/609
"""

from urdfkit.core.words import counted
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.plugins import Parameter, Plugin
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import gazebo_xml, plugin_xml, solid_xml
from urdfkit.text.document import Attribute, Element

_PAIRS = "num_wheel_pairs"
BAD = robot_xml(
    solid_xml("arm"),
    gazebo_xml(plugin_xml("pose", "libgazebo_ros_p3d.so", "<topicName>arm_pose</topicName>")),
)
GOOD = BAD.replace("    <topic", "    <bodyName>arm</bodyName>\n    <topic")


@rule(Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    for use in context.plugins:
        candidates = use.candidates
        missing = [list(_missing(use, plugin, context)) for plugin in candidates]
        if use.plugin in candidates and all(missing) and not _is_of_another(use):
            yield from missing[candidates.index(use.plugin)]
        elif use.plugin is not None and use.plugin.generation == "classic-ros2":
            yield from _missing_wheels(use)


def _missing(use: PluginUse, plugin: Plugin, context: Context) -> Findings:
    filled = {item.path for item in use.items if item.text or _is_of_argument(item.at)}
    blocks = {item.path for item in use.items}
    for parameter in plugin.parameters.values():
        block = parameter.name.rpartition("/")[0]
        if parameter.name in (blocks if parameter.type == "container" else filled):
            continue
        if parameter.required and (not block or block in blocks):
            yield _finding(use, parameter, "")
        elif plugin.missing and parameter.type == "joint" and parameter.default:
            known = context.model.joints_by_name
            if parameter.default not in known and not context.is_part:
                yield _finding(use, parameter, parameter.default)
    if plugin.any_of and filled.isdisjoint(plugin.any_of):
        choice = " or ".join(f"<{name}>" for name in plugin.any_of)
        yield Finding(use.at, f"{use.title}: {choice} is required", f"add {choice}")


def _missing_wheels(use: PluginUse) -> Findings:
    """Another number of wheels than that of the pairs."""
    pairs = use.value(_PAIRS)
    for tag in ("left_joint", "right_joint") if pairs.isdecimal() else ():
        found = len(use.values(tag))
        if found and found != max(int(pairs), 1):  # without any, it is not of ROS 2
            given = use.values(_PAIRS)
            yield Finding(
                given[0].at if given else use.values(tag)[-1].at,
                f"{use.title}: <{_PAIRS}> is {pairs}, but {counted(found, f'<{tag}>')} "
                f"{'is' if found == 1 else 'are'} given: it writes an error and stays idle",
                f"write <{_PAIRS}>{found}</{_PAIRS}>, or as many <{tag}>",
            )
            return


def _is_of_argument(at: Element | Attribute) -> bool:
    """True if the value is that of an argument of the xacro, which is empty by default."""
    if isinstance(at, Attribute):
        return False
    tag = at.tag_at
    return tag.source.data[tag.inner_start : tag.close].strip().startswith(b"$(arg ")


def _is_of_another(use: PluginUse) -> bool:
    """True if the plugin is written for another generation; GAZ016 then reports its tags."""
    assert use.plugin is not None
    others = [plugin for plugin in use.known if plugin.generation != use.plugin.generation]
    unread = len(use.unread(use.plugin))
    return any(not plugin.removed and len(use.unread(plugin)) < unread for plugin in others)


def _finding(use: PluginUse, parameter: Parameter, default: str) -> Finding:
    assert use.plugin is not None
    block, _, name = parameter.name.rpartition("/")
    label = f"attribute {name[1:]}" if name.startswith("@") else f"<{name}>"
    where = f" in <{block}>" if block else ""
    if default:
        message = (
            f"{use.title}: no {label}, and its default '{default}' is not a joint of the robot: "
            f"{use.plugin.missing}"
        )
    else:
        message = f"{use.title}: required {label}{where} is missing"
    severity = None
    if use.plugin.lenient:
        message += ": it writes an error and runs without"
        severity = Severity.WARNING
    return Finding(use.at, message, f"add {label}, a {parameter.type}", severity=severity)

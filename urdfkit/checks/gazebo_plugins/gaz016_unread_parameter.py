"""A plugin does not read a tag.

Gazebo passes every tag to the plugin; tags that the plugin does not read have no effect and cause
no message, and the plugin uses its default. There are four cases:

- The tag is misspelt: a warning, with the intended tag.
- The same plugin reads the tag in another generation of Gazebo and ROS: a warning. The plugins of
  ROS 1 read `<robotBaseFrame>`, those of ROS 2 `<robot_base_frame>`, and topics and the namespace
  moved into a `<ros>` block.
- The tag is left over from another plugin or version: an info. A few tags that the shipped examples
  contain without need, such as `alwaysOn`, are not reported.
- A remapping of ROS 2 names a topic that the plugin does not have, such as `out:=scan`, where the
  topic is `~/out`: a warning.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 1: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    ros-simulation/gazebo_ros_pkgs#1377: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1377
    tu-darmstadt-ros-pkg/hector_gazebo#65: https://github.com/tu-darmstadt-ros-pkg/hector_gazebo/issues/65
"""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.core.suggest import Suggester
from urdfkit.core.words import listed
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Related, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.robot.values import number
from urdfkit.ros.catalog.plugins import Plugin, often_unread, renames
from urdfkit.ros.gazebo.classic_topics import lost_remappings
from urdfkit.ros.gazebo.plugins import PluginParameter, PluginUse
from urdfkit.ros.gazebo.samples import gazebo_xml, plugin_xml, solid_xml
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_tag, rename_element

_TAGS = "<robotBaseFrme>base</robotBaseFrme>", "<odometryFrame>odom</odometryFrame>"
BAD = robot_xml(
    solid_xml("base"), gazebo_xml(plugin_xml("drive", "libgazebo_ros_planar_move.so", *_TAGS))
)
FIXED = GOOD = BAD.replace("Frme", "Frame")

#: Number of tags that a message lists.
_MAX_TAGS = 6

_NAMES = {"classic-ros1": "ROS 1", "classic-ros2": "ROS 2", "gz": "gz-sim", "classic": "no ROS"}


@rule(Severity.INFO, needs=(Need.MODEL, Need.GAZEBO), help="remove it", migrates=True)
def check(context: Context) -> Findings:
    foreign: dict[tuple[PluginUse, bool], list[_UnreadParameter]] = {}
    parameters = [(use, parameter) for use in context.plugins for parameter in _unread(use)]
    for use, parameter in parameters:
        if parameter.other is not None and use.plugin is not None:
            is_renamed = bool(_new_name(use, use.plugin, parameter.item))
            foreign.setdefault((use, is_renamed), []).append(parameter)
        elif parameter.suggested is not None:
            yield _misspelt(use, parameter.item, parameter.suggested)
        else:
            path = "> in <".join(reversed(parameter.item.path.split("/")))
            message = f"{use.title}: unknown element <{path}> (ignored)"
            yield Finding(parameter.item.at, message, group_key=use.filename)
    for (use, _), of_plugin in foreign.items():
        assert use.plugin is not None
        yield _of_other_generation(use, use.plugin, of_plugin)
    for use in context.plugins:
        for lost in lost_remappings(use):
            yield Finding(
                lost.item.at,
                f"{use.title} has no topic '{lost.item.text.partition(':=')[0].strip()}': the "
                "remapping has no effect",
                f"write {lost.topic}:={lost.new}" if lost.topic else "",
                group_key=f"{use.filename} {lost.item.text}",
                severity=Severity.WARNING,
            )


def _misspelt(use: PluginUse, item: PluginParameter, name: str) -> Finding:
    element = item.at
    assert isinstance(element, Element)
    return Finding(
        element,
        f"{use.title}: unknown element <{element.tag}> (ignored)",
        f"did you mean <{name}>?",
        fix_tag(element, name),
        group_key=f"{use.filename} misspelt",
        severity=_severity(_is_default(use.plugin, name, element.text)),
    )


def _severity(is_default: bool) -> Severity:
    return Severity.INFO if is_default else Severity.WARNING


def _is_default(plugin: Plugin | None, name: str, text: str) -> bool:
    """True if a parameter has this value without the tag, so that nothing is lost."""
    parameter = plugin.parameters.get(name) if plugin else None
    if parameter is None or parameter.default is None:
        return False
    value, default = number(text.strip()), number(parameter.default)
    return value == default if value is not None else parameter.default == " ".join(text.split())


def _of_other_generation(
    use: PluginUse, plugin: Plugin, parameters: list[_UnreadParameter]
) -> Finding:
    """One finding for the tags of a plugin that were written for another generation.

    They all have another name here, which a fix writes; or none of them has.
    """
    first, *others = parameters
    element, other = first.item.at, first.other
    assert isinstance(element, Element)
    assert other is not None
    title, edits = _rename(use, plugin, [parameter.item for parameter in parameters])
    tags = [f"<{parameter.item.path.rpartition('/')[2]}>" for parameter in parameters]
    return Finding(
        element,
        f"{use.title} reads {listed(tags, _MAX_TAGS)} in "
        f"{_NAMES[other.generation]}, but not in {_NAMES[plugin.generation]}",
        _advice(first.item, plugin),
        Fix.of(title, edits),
        related=tuple(
            Related(parameter.item.at.span, f"{tag}: {_advice(parameter.item, plugin)}")
            for tag, parameter in zip(tags[1:], others, strict=True)
        ),
        group_key=f"{use.filename} {'renamed' if edits else 'other'}",
        severity=_severity(all(_is_default(p.other, p.item.path, p.item.text) for p in parameters)),
    )


def _rename(
    use: PluginUse, plugin: Plugin, items: list[PluginParameter]
) -> tuple[str, tuple[Edit, ...]]:
    """The edits that rename tags to their names in this generation."""
    edits: dict[str, tuple[str, tuple[Edit, ...]]] = {}
    for item in items:
        new = _new_name(use, plugin, item)
        if new and new not in edits and isinstance(item.at, Element):
            edits[new] = (item.at.tag, rename_element(item.at, new) or ())
    titles = (f"<{old}> to <{new}>" for new, (old, _) in edits.items())
    return f"rename {', '.join(titles)}", tuple(e for _, own in edits.values() for e in own)


def _new_name(use: PluginUse, plugin: Plugin, item: PluginParameter) -> str | None:
    """The name of a tag in this generation, unless the plugin already has a tag of that name."""
    new = _renamed(item, plugin)
    return new if new and not use.values(new) and isinstance(item.at, Element) else None


def _renamed(item: PluginParameter, plugin: Plugin) -> str | None:
    """The name that the same parameter has in this generation."""
    table = renames()
    if plugin.generation == "classic-ros1":
        table = {new: old for old, new in table.items()}
    name = table.get(item.path, "")
    return name if name in plugin.parameters and "/" not in name else None


def _advice(item: PluginParameter, plugin: Plugin) -> str:
    if new := _renamed(item, plugin):
        return f"write <{new}>"
    if plugin.generation != "classic-ros2":
        return "write the tags that it reads there, or use the plugin of that generation"
    if item.path == "robotNamespace":
        return "write <ros><namespace>...</namespace></ros>"
    if item.path in ("updateRate", "updateRateHZ"):
        return "write the rate as <update_rate> of the sensor"
    if "topic" in item.path.lower():
        return "write <ros><remapping>FROM:=TO</remapping></ros>"
    return "remove it, or write what the plugin reads there"


class _UnreadParameter(Record):
    """A tag that a plugin does not read."""

    item: PluginParameter  # the tag
    other: Plugin | None  # the plugin of another generation that reads it, or None
    suggested: str | None  # the tag that it is probably a typo of, or None


def _unread(use: PluginUse) -> list[_UnreadParameter]:
    """Tags that a plugin does not read; empty for an unknown plugin.

    Superfluous tags in shipped examples are ignored.
    """
    plugin = use.plugin
    if plugin is None or not plugin.parameters:
        return []
    unread_items = use.unread(plugin)
    if not unread_items:
        return []
    common = {name for names in often_unread().values() for name in names}
    written = {item.path for item in use.items}
    suggester = Suggester([name for name in plugin.parameters if name not in written])
    tags: list[_UnreadParameter] = []
    for item in unread_items:
        other = _other(use, plugin, item)
        suggested = None if "/" in item.path else suggester.suggested(item.path) or None
        is_cut_short = suggested is not None and suggested.startswith(
            item.path
        )  # updateRate(HZ) of an IMU
        if other is None and item.path in common and not is_cut_short:
            continue
        tags.append(
            _UnreadParameter(item, other, suggested if suggested and "/" not in suggested else None)
        )
    return tags


def _other(use: PluginUse, plugin: Plugin, item: PluginParameter) -> Plugin | None:
    """The plugin of another generation that reads a tag."""
    for candidate in use.known:
        if (
            candidate.generation != plugin.generation
            and not candidate.removed
            and candidate.reads(item.path)
        ):
            return candidate
    new_name = renames().get(item.path)
    if plugin.generation == "classic-ros2" and new_name and plugin.reads(new_name):
        return next(
            (candidate for candidate in use.known if candidate.generation == "classic-ros1"), None
        )
    return None

"""What gz-sim has instead of a plugin of Gazebo Classic, as XML with the values of the plugin."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from urdfkit.robot.values import number
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.plugins import Plugin, find
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.text.diagnostic import Edit, Fix
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import STEP, remove_element, replace

#: What SDF calls the frame of a sensor's messages in Fortress.
_FORTRESS = {"gz_frame_id": "ignition_frame_id"}
#: What Gazebo Classic takes for no topic.
_NO_TOPIC = ("", "__default_topic__")


def successor(use: PluginUse, target: str) -> Fix | None:
    """The fix that writes what gz-sim reads in the place of a plugin.

    Args:
        use: the plugin.
        target: a target with gz-sim.

    Returns:
        None where nothing is known of the plugin, or a value has no counterpart.
    """
    classic = [one for one in use.known if one.generation.startswith("classic")]
    if not classic:
        return None
    plugin = min(classic, key=lambda one: (one.removed, len(use.unread(one))))
    known = data("successors")
    if systems := known["systems"].get(use.filename):
        lines = _systems(use, plugin, systems, target)
        names = " and ".join(systems)
        return Fix.of(f"write {names}", replace(use.at.tag_at.whole_span, lines) if lines else None)
    if use.place == "sensor" and (tags := known["sensors"].get(use.filename)):
        return _sensor(use, plugin, tags, target)
    return None


def _systems(
    use: PluginUse, plugin: Plugin, systems: Mapping[str, Mapping[str, str]], target: str
) -> list[str]:
    """The lines of the systems; none where a value has no counterpart."""
    lines: list[str] = []
    for file, tags in systems.items():
        lines.append("<plugin {} {}>".format(*_attributes(file, target)))
        for tag, names in tags.items():
            values = list(_values(use, plugin, names))
            if tag == "wheel_radius":
                values = [_half(value) for value in values]
            is_single = not tag.endswith(("joint", "joint_name"))
            if "" in values or (is_single and len(set(values)) > 1):
                return []
            lines += [f"{STEP}<{tag}>{value}</{tag}>" for value in dict.fromkeys(values)]
        lines.append("</plugin>")
    return lines


def _attributes(file: str, target: str) -> tuple[str, str]:
    """What a plugin of a system is called in a target."""
    (system,) = find(file)
    if target == "gz-fortress":
        return f'filename="{system.fortress_files[0]}"', f'name="{system.fortress_class}"'
    return f'filename="{file}"', f'name="{system.class_name}"'


def _sensor(use: PluginUse, plugin: Plugin, tags: Mapping[str, str], target: str) -> Fix | None:
    """The tags of the sensor itself, which its plugin gave in Gazebo Classic."""
    sensor = use.at.parent
    assert sensor is not None
    topic = sensor.child("topic")
    edits: tuple[Edit, ...] = ()
    lines = []
    for tag, names in tags.items():
        if tag == "system":
            continue
        if tag == "topic" and topic is not None:
            if topic.text.strip() not in _NO_TOPIC:
                continue
            edits = remove_element(topic)
        name = _FORTRESS.get(tag, tag) if target == "gz-fortress" else tag
        lines += [f"<{name}>{value}</{name}>" for value in _values(use, plugin, names)]
    if not lines:
        return None
    system = " ".join(_attributes(tags["system"], target))
    title = f"write {' and '.join(lines)}; the world needs <plugin {system}/>"
    return Fix.of(title, edits + replace(use.at.tag_at.whole_span, lines))


def _values(use: PluginUse, plugin: Plugin, names: str) -> Iterator[str]:
    """What a plugin of one generation has for a tag, as it is written, or its defaults."""
    for name in re.split(r"[ +]", names):
        if name.startswith("~"):
            if plugin.generation == "classic-ros2":
                yield _remapped(use).get(name[1:], name[1:].removeprefix("~/"))
        elif "/" in name:
            yield from _below(use, plugin, *name.split("/"))
        elif written := [item.at for item in use.values(name) if isinstance(item.at, Element)]:
            for element in written:
                yield from filter(None, re.split(r"[,\s]+", element.tag_at.inner_span.text))
        elif (parameter := plugin.parameters.get(name)) and parameter.default is not None:
            yield parameter.default


def _below(use: PluginUse, plugin: Plugin, above: str, name: str) -> Iterator[str]:
    """A topic below a name, if a plugin reads that, or the one that begins with a slash."""
    if above in plugin.parameters:
        sensor = use.at.parent.get("name") if use.at.parent else ""
        topic = next(_values(use, plugin, name), name)
        first = next(_values(use, plugin, above), sensor or "")
        yield topic if topic.startswith("/") else f"{first.rstrip('/')}/{topic}"


def _remapped(use: PluginUse) -> dict[str, str]:
    """The topics of a node of ROS 2 by the names that its plugin gives them."""
    pairs = (item.text.partition(":=") for item in use.values("ros/remapping"))
    return {name.strip(): topic.strip() for name, _, topic in pairs if topic}


def _half(value: str) -> str:
    """Half of a number or an expression; empty for another text."""
    if (found := number(value)) is not None:
        return f"{found / 2:.10g}"
    expression = re.fullmatch(r"\$\{([^{}]*)\}", value)
    return f"${{({expression.group(1)})/2}}" if expression else ""

"""Replacements in gz-sim for plugins of Gazebo Classic, as XML with the values of the plugin."""

import re
from collections.abc import Iterator, Mapping

from urdfkit.robot.values import number
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.plugins import Plugin, find
from urdfkit.ros.gazebo.plugins import PluginParameter, PluginUse
from urdfkit.text.diagnostic import Edit, Fix
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import STEP, remove_element, replace

#: SDF's tag for the frame of a sensor's messages in Fortress.
_FORTRESS = {"gz_frame_id": "ignition_frame_id"}
#: Values that Gazebo Classic interprets as no topic.
_NO_TOPIC = ("", "__default_topic__")


def successor(use: PluginUse, target: str) -> Fix | None:
    """The fix that replaces a plugin by its replacement in gz-sim.

    Args:
        use: the plugin.
        target: a target with gz-sim.

    Returns:
        None if the plugin is unknown, or a value has no counterpart.
    """
    classic = [plugin for plugin in use.known if plugin.generation.startswith("classic")]
    if not classic:
        return None
    plugin = min(classic, key=lambda candidate: (candidate.removed, len(use.unread(candidate))))
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
    """XML lines of the systems; empty if a value has no counterpart."""
    lines: list[str] = []
    for file, tags in systems.items():
        lines.append("<plugin {} {}>".format(*_attributes(file, target)))
        for tag, names in tags.items():
            values = list(_values(use, plugin, tag, names))
            if tag == "wheel_radius":
                values = [_half(value) for value in values]
            is_single = not tag.endswith(("joint", "joint_name"))
            if "" in values or (is_single and len(set(values)) > 1):
                return []
            lines += [f"{STEP}<{tag}>{value}</{tag}>" for value in dict.fromkeys(values)]
        lines.append("</plugin>")
    return lines


def _attributes(file: str, target: str) -> tuple[str, str]:
    """File name and name attributes of a system's plugin in a target."""
    (system,) = find(file)
    if target == "gz-fortress":
        return f'filename="{system.fortress_files[0]}"', f'name="{system.fortress_class}"'
    return f'filename="{file}"', f'name="{system.class_name}"'


def _sensor(use: PluginUse, plugin: Plugin, tags: Mapping[str, str], target: str) -> Fix | None:
    """Tags of the sensor itself, which its plugin has in Gazebo Classic."""
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
        lines += [f"<{name}>{value}</{name}>" for value in _values(use, plugin, tag, names)]
    if not lines:
        return None
    system = " ".join(_attributes(tags["system"], target))
    title = f"write {' and '.join(lines)}; the world needs <plugin {system}/>"
    return Fix.of(title, edits + replace(use.at.tag_at.whole_span, lines))


def _values(use: PluginUse, plugin: Plugin, tag: str, names: str) -> Iterator[str]:
    """Values of a plugin for a tag, as written, or its defaults."""
    for name in re.split(r"[ +]", names):
        if name.startswith("~"):
            values = _remapped(use, name[1:]) if plugin.generation == "classic-ros2" else []
        elif "/" in name:
            values = _below(use, plugin, *name.split("/"))
        else:
            values = _parameter(use, plugin, name)
        yield from (
            _in_namespace(use, value) if tag.endswith("topic") else value for value in values
        )


def _parameter(use: PluginUse, plugin: Plugin, name: str) -> list[str]:
    """Values of a parameter, with unevaluated expressions; else its default."""
    known = plugin.parameters.get(name)
    if written := list(filter(None, map(_written, use.values(name)))):
        is_list = known is not None and known.type == "joints"
        return re.findall(r"[^,\s]+", written[0]) if is_list else written
    return [known.default] if known and known.default is not None else []


def _written(item: PluginParameter) -> str:
    return item.at.tag_at.inner_span.text.strip() if isinstance(item.at, Element) else ""


def _below(use: PluginUse, plugin: Plugin, prefix: str, name: str) -> list[str]:
    """A topic below a name, if a plugin reads the name; an absolute topic is unchanged."""
    if prefix not in plugin.parameters:
        return []
    assert use.at.parent is not None
    sensor = use.at.parent.attributes.get("name")
    (topic, *_) = _parameter(use, plugin, name) or [name]
    (first, *_) = _parameter(use, plugin, prefix) or [sensor.span.text if sensor else ""]
    full_topic = topic if topic.startswith("/") else f"{first.rstrip('/')}/{topic}"
    return _remapped(use, full_topic)


def _remapped(use: PluginUse, name: str) -> list[str]:
    """The ROS 2 topic to which a topic of a plugin is remapped."""
    pairs = (_written(item).partition(":=") for item in use.values("ros/remapping"))
    topic = name.lstrip("/")
    topics = [new.strip() for old, _, new in pairs if old.strip().lstrip("/") == topic and new]
    return topics[:1] or [name.removeprefix("~/")]


def _in_namespace(use: PluginUse, topic: str) -> str:
    """A topic in the namespace of the node, unless it begins with a slash."""
    parameters = (*use.values("ros/namespace"), *use.values("robotNamespace"))
    namespace = next(filter(None, map(_written, parameters)), "").rstrip("/")
    return topic if topic.startswith("/") or not namespace else f"{namespace}/{topic}"


def _half(value: str) -> str:
    """Half of a number or an expression; empty for another text."""
    if (number_value := number(value)) is not None:
        return f"{number_value / 2:.10g}"
    expression = re.fullmatch(r"\$\{([^{}]*)\}", value)
    return f"${{({expression.group(1)})/2}}" if expression else ""

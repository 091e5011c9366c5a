"""Topics on which the plugins of Gazebo Classic publish in ROS 2: ``catalog/bridge.json``.

Source: ``node.cpp`` of gazebo_ros: a relative name is in the namespace, ``~/`` stands for the node,
which is called like the plugin.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.plugins import PluginParameter, PluginUse

#: What stands for the name of a camera, which is that of its sensor by default.
_CAMERA = "camera_name"
_OTHER_CAMERAS = ("multicamera", "wideanglecamera")
_TRUE = ("true", "1")
#: Encodings of image_transport: ``image_raw/compressed``.
_TRANSPORTS = ("compressed", "compressedDepth", "ffmpeg", "theora", "zstd")
#: Topics that any node may have.
_OF_ALL = ("tf", "tf_static", "clock", "diagnostics", "rosout", "parameter_events")


class ClassicTopic(Record):
    """A topic of a plugin."""

    message: str  # of ROS, without its package
    written: str  # as in the plugin, before remapping
    name: str  # in full
    plugin: PluginUse


def classic_topics(uses: Iterable[PluginUse], namespace: str = "") -> list[ClassicTopic] | None:
    """The topics of the plugins of a robot; None if some may be unknown.

    Args:
        namespace: of all plugins, from the program that spawns the robot.
    """
    topics: list[ClassicTopic] = []
    facts = data("bridge")
    for use in uses:
        entries = [text for text in facts["classic"].get(use.filename, "").split(", ") if text]
        if not entries and use.filename not in facts["silent_classic"].split():
            return None
        is_unknown = use.values("ros/argument") or _sensor(use, "type") in _OTHER_CAMERAS
        if is_unknown or (entries and use.plugin is None):
            return None
        for entry in entries:
            message, written, *condition = entry.split()
            if _holds(condition, use):
                written = _with_camera(written, use)
                name = _full_name(written, use, namespace)
                topics.append(ClassicTopic(_message(message, use), written, name, use))
    return topics


class LostRemapping(Record):
    """A remapping of a topic that a plugin does not have."""

    item: PluginParameter
    topic: str  # that it has instead, as in the plugin; empty if none is like it
    new: str


def lost_remappings(use: PluginUse) -> Iterator[LostRemapping]:
    """Remappings without effect of a plugin whose topics are all known."""
    facts, space = data("bridge"), use.value("ros/namespace").strip("/")
    others = facts["read_by_classic"].get(use.filename)
    if others is None or use.plugin is None or _sensor(use, "type") in _OTHER_CAMERAS:
        return
    entries = [text.split() for text in facts["classic"][use.filename].split(", ")]
    read = [_with_camera(name, use) for name in others.split()]
    written = [_with_camera(entry[1], use) for entry in entries if _holds(entry[2:], use)] + read
    names = {_resolved(_with_camera(entry[1], use), space, use) for entry in entries}
    names.update(_resolved(name, space, use) for name in read)
    for item in use.values("ros/remapping"):
        old, _, new = (part.strip() for part in item.text.partition(":="))
        is_open = new in ("", old) or any(mark in item.text for mark in "${")
        is_open = is_open or old.strip("/") in _OF_ALL
        resolved = {_resolved(_base(name), space, use) for name in (old, new)}
        if not is_open and resolved.isdisjoint(names):
            yield LostRemapping(item, _likely(old, written), new)


def _base(topic: str) -> str:
    """The topic of an image, which image_transport also publishes in other encodings below it."""
    base, _, last = topic.rpartition("/")
    return base if last in _TRANSPORTS else topic


#: Words of topics whose messages are of another kind than those of an image.
_KINDS = {"depth", "points"}


def _likely(old: str, written: list[str]) -> str:
    """The topic that a wrong name stands for: that which ends with it, or has most of its words."""
    words, ending = _words(old.rpartition("/")[2]), "/" + old.lstrip("~/")
    common = {name: len(words & _words(name.partition("/")[2])) for name in written}
    likely = max(written, key=lambda name: (name.endswith(ending), common[name]))
    is_of_other_kind = (words & _KINDS) - _words(likely)
    is_likely = len(written) == 1 or common[likely]
    return likely if is_likely and not is_of_other_kind else ""


def _words(topic: str) -> set[str]:
    return set(re.split("[/_]", topic))


def _with_camera(written: str, use: PluginUse) -> str:
    return written.replace(_CAMERA, use.value(_CAMERA) or _sensor(use, "name"))


def _holds(condition: list[str], use: PluginUse) -> bool:
    """True if a parameter is true, or if the sensor has the type."""
    is_of_type = condition == [_sensor(use, "type")]
    return not condition or is_of_type or use.value(condition[0]).lower() in _TRUE


def _sensor(use: PluginUse, attribute: str) -> str:
    parent = use.at.parent
    return (parent.get(attribute) or "") if parent is not None and parent.tag == "sensor" else ""


def _message(message: str, use: PluginUse) -> str:
    return use.value(message[1:]).rpartition("/")[2] if message.startswith("@") else message


def _full_name(written: str, use: PluginUse, namespace: str) -> str:
    """The name of a topic after remapping."""
    space = (namespace or use.value("ros/namespace")).strip("/")
    renames = dict(_rule(item.text, space, use) for item in use.values("ros/remapping"))
    name = _resolved(written, space, use)
    return renames.get(name, name)


def _rule(text: str, space: str, use: PluginUse) -> tuple[str, str]:
    old, _, new = text.partition(":=")
    return _resolved(old, space, use), _resolved(new, space, use)


def _resolved(name: str, space: str, use: PluginUse) -> str:
    if name.startswith("/"):
        return name
    own = f"{use.name}{name[1:]}" if name.startswith("~") else name
    return "/" + "/".join(part for part in (space, own) if part)

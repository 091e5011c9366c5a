"""Gazebo topics that the sensors and systems of a robot publish or subscribe."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase

from urdfkit.core.record import Record
from urdfkit.robot.model import RobotModel
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.sensors import type_in_gz
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.document import Element


class GazeboTopic(Record):
    """A topic of a robot."""

    who: str  # for messages
    message: str  # Gazebo's message type, such as ``LaserScan``
    name: str  # without surrounding slashes; ``*`` for the names of world and robot
    is_read: bool = False  # True if the robot subscribes, as for commands
    tag: str = "topic"  # the tag that defines it
    #: Suffix that a sensor adds: after a slash, or after two dots instead of the last part.
    suffix: str = ""
    is_system: bool = False  # True for the topic of a plugin

    @property
    def is_unnamed(self) -> bool:
        """True if the description does not define its name."""
        return "*" in self.name

    def named(self, name: str) -> str:
        """Text for the tag that yields the name of the topic."""
        if self.suffix.startswith("./"):
            return name.removesuffix(self.suffix[1:]) + "/image"
        return name.removesuffix(self.suffix) or name

    def is_called(self, name: str) -> bool:
        """True if it has this name, ignoring surrounding slashes."""
        return fnmatchcase(name.strip("/"), self.name)


def topics(model: RobotModel) -> Iterator[GazeboTopic]:
    """Topics of the catalogued sensors and systems of a robot."""
    for sensor in sensors(model):
        yield from _of_sensor(sensor)
    for gazebo in model.gazebo:
        for plugin in gazebo.all("plugin"):
            yield from of_plugin(plugin)


def _of_sensor(sensor: Sensor) -> Iterator[GazeboTopic]:
    written = sensor.find("topic")
    topic = written.text.strip().strip("/") if written else ""
    is_default = not topic
    topic = topic or f"world/*/sensor/{sensor.name}/*"
    for entry in _entries("sensors", type_in_gz(sensor.type)):
        message, _, path = entry.partition(" ")
        parent = topic.rpartition("/")[0]
        start = ".." if path.startswith("..") else "."
        name = path.replace(start, parent if start == ".." else topic, 1)
        info = sensor.find("camera/camera_info_topic")
        if message == "CameraInfo" and info is not None:
            name = info.text.strip()
        name = topic if is_default else name.strip("/")
        yield GazeboTopic(sensor.who, message, name, suffix=path[1:])


def of_plugin(plugin: Element) -> Iterator[GazeboTopic]:
    """The topics of a system, if it is catalogued."""
    below_model = plugin.child("sub_topic")
    for entry in _entries("plugins", _library(plugin)):
        message, parameter, default = entry.split()
        if message == "Double" and plugin.child("use_actuator_msg") is not None:
            continue  # it reads Actuators
        tags = parameter[1:].split("/")
        written = [plugin.child(tag) for tag in tags]
        texts = [tag.text.strip().strip("/") if tag is not None else "" for tag in written]
        defaults = default.strip("/").rsplit("/", len(tags) - 1)
        name = "/".join(text or part for text, part in zip(texts, defaults, strict=True))
        if below_model is not None and name == default.strip("/"):
            name = f"model/*/{below_model.text.strip().strip('/')}"
        who = f"plugin '{plugin.get('name')}'"
        is_read = parameter.startswith("<")
        yield GazeboTopic(who, message, name, is_read, tags[-1], is_system=True)


def _library(plugin: Element) -> str:
    return (plugin.get("filename") or "").strip().removeprefix("lib").removesuffix(".so")


def are_all_known(model: RobotModel) -> bool:
    """True if the topics of all sensors and systems of the robot are catalogued."""
    plugins = (_library(plugin) for gazebo in model.gazebo for plugin in gazebo.all("plugin"))
    silent, silent_sensors = (data("bridge")[key].split() for key in ("silent", "silent_sensors"))
    return all(
        _entries("sensors", type_in_gz(sensor.type)) or sensor.type in silent_sensors
        for sensor in sensors(model)
    ) and all(_entries("plugins", plugin) or plugin in silent for plugin in plugins)


def _entries(section: str, key: str) -> list[str]:
    return [entry for entry in data("bridge")[section].get(key, "").split(", ") if entry]

"""The topics in Gazebo on which the sensors and systems of a robot publish, or which they read."""

from __future__ import annotations

from collections.abc import Iterator
from fnmatch import fnmatchcase

from urdfkit.core.record import Record
from urdfkit.robot.model import RobotModel
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.document import Element


class GazeboTopic(Record):
    """A topic of a robot."""

    who: str  # for messages
    message: str  # of Gazebo, such as ``LaserScan``
    name: str  # without slashes around it; ``*`` stands for the names of the world and the robot
    is_read: bool = False  # True if the robot reads it, as it does with commands
    is_default: bool = False  # True if the description does not name it
    is_system: bool = False  # True for that of a plugin

    def is_called(self, name: str) -> bool:
        """True if it has this name, which may have slashes around it."""
        return fnmatchcase(name.strip("/"), self.name)


def topics(model: RobotModel) -> Iterator[GazeboTopic]:
    """The topics of the sensors and systems of a robot that are catalogued."""
    for sensor in sensors(model):
        yield from _of_sensor(sensor)
    for gazebo in model.gazebo:
        for plugin in gazebo.all("plugin"):
            yield from _of_plugin(plugin)


def _of_sensor(sensor: Sensor) -> Iterator[GazeboTopic]:
    written = sensor.find("topic")
    topic = written.text.strip().strip("/") if written else ""
    is_default = not topic
    topic = topic or f"world/*/sensor/{sensor.name}/*"
    for entry in _entries("sensors", sensor.type):
        message, _, path = entry.partition(" ")
        above = topic.rpartition("/")[0]
        start = ".." if path.startswith("..") else "."
        name = path.replace(start, above if start == ".." else topic, 1)
        info = sensor.find("camera/camera_info_topic")
        if message == "CameraInfo" and info is not None:
            name = info.text.strip()
        name = topic if is_default else name.strip("/")
        yield GazeboTopic(sensor.who, message, name, is_default=is_default)


def _of_plugin(plugin: Element) -> Iterator[GazeboTopic]:
    file = (plugin.get("filename") or "").strip().removeprefix("lib").removesuffix(".so")
    for entry in _entries("plugins", file):
        message, parameter, default = entry.split()
        written = plugin.child(parameter[1:])
        name = (written.text if written is not None else "").strip().strip("/")
        who = f"plugin '{plugin.get('name')}'"
        is_read = parameter.startswith("<")
        default = default.strip("/")
        yield GazeboTopic(who, message, name or default, is_read, not name, is_system=True)


def _entries(section: str, key: str) -> list[str]:
    return [entry for entry in data("bridge")[section].get(key, "").split(", ") if entry]

"""The links that see: those with a lidar or a camera, by their `<sensor>` or by their name."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin, tan
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, from_rpy
from urdfkit.robot.model import numbers
from urdfkit.ros.gazebo.sensors import Sensor, sensors

if TYPE_CHECKING:
    from urdfkit.robot.model import RobotModel

#: Words in the names of links.
LIDARS = ("laser", "lidar", "hokuyo", "velodyne", "ouster")
CAMERAS = ("camera", "kinect", "realsense")

#: Words in the names of links beside them, or of those that stand for no real sensor.
_OTHERS = (
    "mount", "bracket", "holder", "support", "screw", "stand", "pole", "plate", "adapter", "base",
    "housing", "parent", "optical", "virtual", "imu", "gyro", "accel", "cover", "sonar",
)  # fmt: skip

#: The types of sensors that hold these words.
_RAYS, _PICTURES = ("ray", "lidar"), ("camera", "depth")

#: Beams of a lidar that are looked at; and half the angle in which a camera sees, in rad.
_BEAMS, _HALF = 16, 0.4


class OpticalSensor(Record):
    """A lidar or a camera.

    Attributes:
        link: the name of its link.
        who: for messages.
        kind: ``lidar`` or ``camera``.
        type: of the ``<sensor>``; empty if only the name of the link says so.
        frame: of the sensor in the link: it looks along x, or around z.
        least: the distance in m from which on it sees.
        sweep: the first and the last angle of a lidar, in rad.
    """

    link: str
    who: str
    kind: str
    type: str = ""
    frame: Transform = Transform()
    least: float = 0.0
    sweep: tuple[float, float] = (-pi, pi)

    @property
    def directions(self) -> list[Vector]:
        """In which it looks, as unit vectors in its frame."""
        if self.kind == "lidar":
            first, last = self.sweep
            angles = (first + (last - first) * n / (_BEAMS - 1) for n in range(_BEAMS))
            return [(cos(angle), sin(angle), 0.0) for angle in angles]
        aside, ahead = tan(_HALF), 1 / (1 + 2 * tan(_HALF) ** 2) ** 0.5
        corners = [(a, b) for a in (-aside, aside) for b in (-aside, aside)]
        return [(1.0, 0.0, 0.0), *((ahead, a * ahead, b * ahead) for a, b in corners)]


def optical_sensors(model: RobotModel) -> Iterator[OpticalSensor]:
    """The eyes of a model: those that Gazebo simulates, and other links that are called so."""
    found = [eye for sensor in sensors(model) if (eye := _of(sensor))]
    yield from found
    known = {eye.link for eye in found}
    for link in model.links:
        if link.name not in known and (kind := kind_of(link.name)):
            yield OpticalSensor(link.name, f"link '{link.name}'", kind)


def kind_of(name: str) -> str:
    """``lidar`` or ``camera`` for a link that is called so; empty for others."""
    name = name.lower()
    if any(word in name for word in _OTHERS):
        return ""
    if any(word in name for word in LIDARS):
        return "lidar"
    return "camera" if any(word in name for word in CAMERAS) else ""


def _of(sensor: Sensor) -> OpticalSensor | None:
    pose = sensor.find("pose")
    place = numbers(pose.text) if pose else (0.0,) * 6
    if place is None or len(place) != 6 or (pose and pose.attributes):
        return None
    frame = Transform(from_rpy(*place[3:]), (place[0], place[1], place[2]))
    if any(word in sensor.type for word in _PICTURES):
        near = sensor.number("camera/clip/near")
        return OpticalSensor(
            sensor.reference, sensor.who, "camera", sensor.type, frame, near.value if near else 0.0
        )
    if not sensor.lidar or not any(word in sensor.type for word in _RAYS):
        return None
    if "sonar" in f"{sensor.name} {sensor.reference}".lower():
        return None
    least = sensor.number(f"{sensor.lidar}/range/min")
    scan = f"{sensor.lidar}/scan/horizontal"
    first, last = (sensor.number(f"{scan}/{end}") for end in ("min_angle", "max_angle"))
    sweep = (first.value, last.value) if first and last else (-pi, pi)
    return OpticalSensor(
        sensor.reference,
        sensor.who,
        "lidar",
        sensor.type,
        frame,
        least.value if least else 0.0,
        sweep,
    )

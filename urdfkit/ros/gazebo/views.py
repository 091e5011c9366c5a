"""Frames, beams and fields of view of the lidars and cameras of a model."""

from math import atan2, hypot, pi, tan

from urdfkit.core.spatial import Transform, Vector, from_rpy, length, times
from urdfkit.robot.ray_casting import Scan
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import numbers
from urdfkit.ros.gazebo.sensors import Sensor

#: Most beams of a scan, and number of rays along an edge of an image, that are tested.
MAX_BEAMS, EDGE = 360, 5
#: Least angle of a scan in rad: narrower scans are of sonars and cliff sensors.
MIN_SCAN_ANGLE = 1.5

_FIELD, _WIDTH, _HEIGHT = 1.047, 320.0, 240.0


def frame_of(sensor: Sensor, tree: KinematicTree) -> Transform | None:
    """The frame of a sensor in the root; None if its link or pose is unknown."""
    frame = tree.frames.get(sensor.reference)
    pose = sensor.find("pose")
    if frame is None or pose is None or not pose.text.strip():
        return frame
    written = numbers(pose.text)
    if pose.attributes or written is None or len(written) != 6:
        return None
    x, y, z, roll, pitch, yaw = written
    return frame @ Transform(from_rpy(roll, pitch, yaw), (x, y, z))


def planar_scan(sensor: Sensor) -> Scan | None:
    """The beams of a lidar that scans one plane; None for other sensors."""
    block = sensor.lidar
    if not block:
        return None
    names = ("samples", "min_angle", "max_angle")
    horizontal = [sensor.number(f"{block}/scan/horizontal/{name}") for name in names]
    vertical = sensor.number(f"{block}/scan/vertical/samples")
    ends = [sensor.number(f"{block}/range/{name}") for name in ("min", "max")]
    samples, first, last, low, top = (item.value if item else None for item in (*horizontal, *ends))
    if samples is None or first is None or last is None or low is None or top is None:
        return None
    is_flat = vertical is None or vertical.value <= 1
    if not is_flat or not MIN_SCAN_ANGLE <= last - first <= 2 * pi + 0.01 or samples < 2 or low < 0:
        return None
    return Scan(first, last, min(int(samples), MAX_BEAMS), low, top)


def is_camera(sensor: Sensor) -> bool:
    return "camera" in sensor.type or sensor.type in ("depth", "rgbd")


def image_rays(sensor: Sensor) -> list[Vector]:
    """Directions across the image of a camera, in its frame: x forwards, z upwards."""
    settings = (
        sensor.number(f"camera/{path}")
        for path in ("horizontal_fov", "image/width", "image/height")
    )
    values = [setting.value if setting else None for setting in settings]
    field, width, height = (
        value if value and value > 0 else default
        for value, default in zip(values, (_FIELD, _WIDTH, _HEIGHT), strict=True)
    )
    if field >= pi:
        return []
    across = tan(field / 2)
    up = across * height / width
    steps = [2 * number / (EDGE - 1) - 1 for number in range(EDGE)]
    rays = ((1.0, across * y, up * z) for y in steps for z in steps)
    return [times(ray, 1 / length(ray)) for ray in rays]


def tilt(frame: Transform) -> float:
    """Angle between z of a frame and the vertical, in rad: 0 if upright, pi if upside down."""
    x, y, z = (row[2] for row in frame.rotation)
    return atan2(hypot(x, y), z)

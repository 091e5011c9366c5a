"""Sensors and cameras in MJCF."""

from itertools import product
from math import atan, cos, degrees, isfinite, sin, tan
from typing import Any

import mujoco
import numpy as np

from urdfkit.core.spatial import Rotation, Transform, basis, from_rpy, multiply, transposed
from urdfkit.core.words import counted
from urdfkit.lint.context import Context
from urdfkit.output.conversion.mjcf_math import quaternion
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.robot.values import numbers
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.document import Element

#: Rays of a lidar at most, since each is a site and a sensor of its own, and rows of them.
MAX_RAYS, MAX_ROWS = 360, 16
#: The group of their sites, which MuJoCo's viewer does not show.
_HIDDEN = 4

#: Gazebo's cameras look along x and have z up, MuJoCo's along -z and have y up.
_CAMERA: Rotation = ((0.0, 0.0, -1.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
_CAMERAS = ("camera", "depth", "rgbd_camera", "depth_camera", "wideanglecamera")

_SENSOR, _OBJECT = mujoco.mjtSensor, mujoco.mjtObj
_IMU = (
    ("orientation", _SENSOR.mjSENS_FRAMEQUAT),
    ("angular_velocity", _SENSOR.mjSENS_GYRO),
    ("linear_acceleration", _SENSOR.mjSENS_ACCELEROMETER),
)
_FORCE_TORQUE = (("force", _SENSOR.mjSENS_FORCE), ("torque", _SENSOR.mjSENS_TORQUE))


def add_sensors(made: MjcfRobot, robot: Context) -> None:
    """Add the sensors of Gazebo's tags to a robot."""
    for sensor in sensors(robot.model):
        _add(made, robot, sensor)


def _add(made: MjcfRobot, robot: Context, sensor: Sensor) -> None:
    body = made.bodies.get(sensor.reference)
    frame = made.frames.get(sensor.reference, Transform()) @ _pose(sensor.at)
    if sensor.type in ("imu", "imu_sensor") and body is not None:
        _measured(made, sensor, body, frame, _IMU)
    elif sensor.type in _CAMERAS and body is not None:
        _camera(made, sensor, body, frame)
    elif sensor.lidar and body is not None:
        _lidar(made, sensor, body, frame)
    elif sensor.type == "force_torque" and sensor.reference in robot.model.joints_by_name:
        child = robot.model.joints_by_name[sensor.reference].child
        if child is not None:
            _measured(made, sensor, made.bodies[child.value], Transform(), _FORCE_TORQUE)
    else:
        made.losses.lose(sensor.at, f"MuJoCo has no sensor like '{sensor.type}'")


def _measured(
    made: MjcfRobot, sensor: Sensor, body: Any, at: Transform, kinds: tuple[tuple[str, Any], ...]
) -> None:
    """A site where a sensor is, and what it measures there."""
    name = made.devices.take(sensor.name or sensor.reference)
    body.add_site(name=name, pos=at.position, quat=quaternion(at.rotation))
    for what, kind in kinds:
        made.spec.add_sensor(
            name=made.devices.take(f"{name}_{what}"),
            type=kind,
            objtype=_OBJECT.mjOBJ_SITE,
            objname=name,
        )
    made.losses.keep(sensor.at, "site and sensors")
    made.losses.keep(sensor.at.parent, "body")
    made.losses.keep(sensor.at.child("pose"), "site")


def _camera(made: MjcfRobot, sensor: Sensor, body: Any, at: Transform) -> None:
    wide = sensor.number("camera/horizontal_fov")
    width, height = sensor.number("camera/image/width"), sensor.number("camera/image/height")
    camera = body.add_camera(
        name=made.devices.take(sensor.name or sensor.reference),
        pos=at.position,
        quat=quaternion(multiply(at.rotation, _CAMERA)),
    )
    made.losses.keep(sensor.at, "camera")
    made.losses.keep(sensor.at.parent, "body")
    made.losses.keep(sensor.at.child("camera"), "camera")
    made.losses.keep(sensor.at.child("pose"), "camera")
    if wide and width and height and width.value > 0 and height.value > 0:
        camera.fovy = degrees(2 * atan(tan(wide.value / 2) * height.value / width.value))
        camera.resolution = (round(width.value), round(height.value))
        made.losses.keep(sensor.find("camera/image"), "resolution")
        for placed, what in ((wide, "fovy"), (width, "resolution"), (height, "resolution")):
            made.losses.keep(placed.at, what)


def _pose(sensor: Element) -> Transform:
    """SDF's ``<pose>``: x y z roll pitch yaw in the frame of the link."""
    pose = sensor.child("pose")
    values = numbers(pose.text) if pose else None
    if values is None or len(values) != 6:
        return Transform()
    x, y, z, *rpy = values
    return Transform(from_rpy(*rpy), (x, y, z))


def _lidar(made: MjcfRobot, sensor: Sensor, body: Any, at: Transform) -> None:
    """A rangefinder for each ray, along the z of a site; rows from below, each from the right."""
    scan = f"{sensor.lidar}/scan"
    rows = _angles(sensor, f"{scan}/vertical", MAX_ROWS)
    columns = _angles(sensor, f"{scan}/horizontal", MAX_RAYS // len(rows))
    rays = _samples(sensor, f"{scan}/vertical") * _samples(sensor, f"{scan}/horizontal")
    farthest = sensor.number(f"{sensor.lidar}/range/max")
    name = made.devices.take(sensor.name or sensor.reference)
    for number, (up, turn) in enumerate(product(rows, columns)):
        way = (cos(up) * cos(turn), cos(up) * sin(turn), sin(up))
        rotation = multiply(at.rotation, transposed(basis(way)))
        ray = made.devices.take(f"{name}_{number}")
        body.add_site(name=ray, pos=at.position, quat=quaternion(rotation), group=_HIDDEN)
        found = made.spec.add_sensor(
            name=ray, type=_SENSOR.mjSENS_RANGEFINDER, objtype=_OBJECT.mjOBJ_SITE, objname=ray
        )
        found.intprm[0] = 1 << int(mujoco.mjtRayDataField.mjRAYDATA_DIST)
        if farthest and 0 < farthest.value < np.inf:
            found.cutoff = farthest.value
            made.losses.keep(sensor.find(f"{sensor.lidar}/range"), "rangefinders")
            made.losses.keep(sensor.find(f"{sensor.lidar}/range/max"), "cutoff")
    made.losses.keep(sensor.at.parent, "body")
    made.losses.keep(sensor.at.child("pose"), "sites")
    made.losses.keep(sensor.at, "rangefinders")
    for path in (sensor.lidar, scan, f"{scan}/horizontal", f"{scan}/vertical"):
        made.losses.keep(sensor.find(path), "rangefinders")
    for axis, tag in product(("horizontal", "vertical"), ("samples", "min_angle", "max_angle")):
        made.losses.keep(sensor.find(f"{scan}/{axis}/{tag}"), "rangefinders")
    count = len(rows) * len(columns)
    if count < rays:
        note = f"{counted(count, 'rangefinder')} for {rays} rays"
        for axis in ("horizontal", "vertical"):
            made.losses.approximate(sensor.find(f"{scan}/{axis}/samples"), note)


def _angles(sensor: Sensor, path: str, most: int) -> list[float]:
    """The angles of the rays of a scan, in rad."""
    first, last = (sensor.number(f"{path}/{end}_angle") for end in ("min", "max"))
    ends = (first.value if first else 0.0, last.value if last else 0.0)
    count = min(_samples(sensor, path), most)
    return [float(angle) for angle in np.linspace(*ends, count)] if count > 1 else [sum(ends) / 2]


def _samples(sensor: Sensor, path: str) -> int:
    written = sensor.number(f"{path}/samples")
    return max(int(written.value), 1) if written and isfinite(written.value) else 1

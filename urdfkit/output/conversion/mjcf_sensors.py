"""Sensors and cameras in MJCF."""

from itertools import product
from math import atan, cos, degrees, isfinite, sin, tan
from typing import Any

import mujoco
import numpy as np

from urdfkit.core.spatial import Rotation, Transform, basis, multiply, transposed
from urdfkit.core.words import counted
from urdfkit.lint.context import Context
from urdfkit.output.conversion.mjcf_pieces import quaternion
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.robot.joint import Joint
from urdfkit.ros.gazebo.poses import UnreadablePose, pose_in
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.document import Element

#: Most rays of a lidar, since each ray is a site and a sensor, and most rows of rays.
MAX_RAYS, MAX_ROWS = 360, 16
#: Group of the sites of rays, which MuJoCo's viewer hides.
_HIDDEN = 4

#: Gazebo's cameras look along x and have z up, MuJoCo's along -z and have y up.
_CAMERA: Rotation = ((0.0, 0.0, -1.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0))
_CAMERAS = ("camera", "depth", "rgbd_camera", "depth_camera", "wideanglecamera")

_IMUS = ("imu", "imu_sensor")

_SENSOR, _OBJECT = mujoco.mjtSensor, mujoco.mjtObj
_IMU = (
    ("orientation", _SENSOR.mjSENS_FRAMEQUAT),
    ("angular_velocity", _SENSOR.mjSENS_GYRO),
    ("linear_acceleration", _SENSOR.mjSENS_ACCELEROMETER),
)
_FORCE_TORQUE = (("force", _SENSOR.mjSENS_FORCE), ("torque", _SENSOR.mjSENS_TORQUE))


def add_sensors(mjcf: MjcfRobot, robot: Context) -> None:
    """Add the sensors of Gazebo's tags to a robot."""
    for sensor in sensors(robot.model):
        _add(mjcf, robot, sensor)


def _add(mjcf: MjcfRobot, robot: Context, sensor: Sensor) -> None:
    joints = robot.model.joints_by_name if sensor.type == "force_torque" else {}
    joint = joints.get(sensor.reference)
    is_known = joint is not None or sensor.type in (*_IMUS, *_CAMERAS) or bool(sensor.lidar)
    link = joint.child_name if joint is not None else sensor.reference
    body = mjcf.bodies.get(link)
    if body is None or not is_known:
        mjcf.losses.lose(sensor.at, f"no MuJoCo sensor for type '{sensor.type}'")
        return
    frame, pose = mjcf.frames[link], _pose(mjcf, robot, sensor.at, link)
    if joint is not None:
        _wrench(mjcf, sensor, joint, frame @ pose)
    elif sensor.type in _IMUS:
        _measured(mjcf, sensor, body, frame @ pose, _IMU)
    elif sensor.type in _CAMERAS:
        camera = sensor.at.child("camera")
        pose = pose if camera is None else _pose(mjcf, robot, camera, link, pose)
        _camera(mjcf, sensor, body, frame @ pose)
    else:
        _lidar(mjcf, sensor, body, frame @ pose)
    mjcf.losses.keep(sensor.at.parent, "body")


def _pose(
    mjcf: MjcfRobot, robot: Context, parent: Element, link: str, outer: Transform | None = None
) -> Transform:
    """The pose of a sensor, or of the camera in it, in the frame of a link.

    Args:
        parent: the element with the ``<pose>``.
        outer: pose of the enclosing element.
    """
    pose = parent.child("pose")
    try:
        inner = pose_in(parent, link, robot.tree)
    except UnreadablePose as error:
        mjcf.losses.lose(pose, f"{error}; the MJCF has no pose")
        return outer or Transform()
    mjcf.losses.keep(pose, "pose")
    is_in_outer = pose is None or not pose.get("relative_to")
    return outer @ inner if outer and is_in_outer else inner


def _wrench(mjcf: MjcfRobot, sensor: Sensor, joint: Joint, at: Transform) -> None:
    """Force and torque that the parent of a joint applies to its child, at the sensor.

    Gazebo reports them in the axes of the child or, according to ``<frame>``, of the parent or
    sensor.
    """
    keep, settings = mjcf.losses.keep, sensor.at.child("force_torque")
    frame = settings.child("frame") if settings else None
    axes = frame.text.strip() if frame else "child"
    rotation = at.rotation
    if axes != "sensor":
        rotation = mjcf.frames[joint.child_name].rotation
    if axes == "parent":
        rotation = multiply(rotation, joint.origin.inverse.rotation)
    site = Transform(rotation, at.position)
    _measured(mjcf, sensor, mjcf.bodies[joint.child_name], site, _FORCE_TORQUE)
    keep(settings, "sensors")
    keep(frame, "axes of the site")
    if axes == "parent" and joint.kind != "fixed":
        mjcf.losses.approximate(frame, "axes of the parent with the joint at zero")
    direction = settings.child("measure_direction") if settings else None
    if direction is not None and direction.text.strip() == "parent_to_child":
        keep(direction, "sensors")
    else:
        note = "MuJoCo measures the load from parent to child: the signs are opposite"
        mjcf.losses.approximate(sensor.at if direction is None else direction, note)


def _measured(
    mjcf: MjcfRobot, sensor: Sensor, body: Any, at: Transform, kinds: tuple[tuple[str, Any], ...]
) -> None:
    """Add a site for a sensor, and MuJoCo's sensors there."""
    name = mjcf.devices.take(sensor.name or sensor.reference)
    body.add_site(name=name, pos=at.position, quat=quaternion(at.rotation))
    for quantity, kind in kinds:
        mjcf.spec.add_sensor(
            name=mjcf.devices.take(f"{name}_{quantity}"),
            type=kind,
            objtype=_OBJECT.mjOBJ_SITE,
            objname=name,
        )
    mjcf.losses.keep(sensor.at, "site and sensors")


def _camera(mjcf: MjcfRobot, sensor: Sensor, body: Any, at: Transform) -> None:
    fov = sensor.number("camera/horizontal_fov")
    width, height = sensor.number("camera/image/width"), sensor.number("camera/image/height")
    camera = body.add_camera(
        name=mjcf.devices.take(sensor.name or sensor.reference),
        pos=at.position,
        quat=quaternion(multiply(at.rotation, _CAMERA)),
    )
    mjcf.losses.keep(sensor.at, "camera")
    mjcf.losses.keep(sensor.at.child("camera"), "camera")
    if not width or not height:
        why = "MuJoCo's vertical angle requires <width> and <height> in <image>"
        mjcf.losses.lose(fov.at if fov else None, why)
    if fov and width and height and width.value > 0 and height.value > 0:
        camera.fovy = degrees(2 * atan(tan(fov.value / 2) * height.value / width.value))
        camera.resolution = (round(width.value), round(height.value))
        mjcf.losses.keep(sensor.find("camera/image"), "resolution")
        for placed, note in ((fov, "fovy"), (width, "resolution"), (height, "resolution")):
            mjcf.losses.keep(placed.at, note)


def _lidar(mjcf: MjcfRobot, sensor: Sensor, body: Any, at: Transform) -> None:
    """Add a rangefinder per ray, along z of a site; rows from below, each row from the right."""
    scan = f"{sensor.lidar}/scan"
    rows = _angles(sensor, f"{scan}/vertical", MAX_ROWS)
    columns = _angles(sensor, f"{scan}/horizontal", MAX_RAYS // len(rows))
    rays = _samples(sensor, f"{scan}/vertical") * _samples(sensor, f"{scan}/horizontal")
    farthest = sensor.number(f"{sensor.lidar}/range/max")
    name = mjcf.devices.take(sensor.name or sensor.reference)
    for number, (up, turn) in enumerate(product(rows, columns)):
        direction = (cos(up) * cos(turn), cos(up) * sin(turn), sin(up))
        rotation = multiply(at.rotation, transposed(basis(direction)))
        ray = mjcf.devices.take(f"{name}_{number}")
        body.add_site(name=ray, pos=at.position, quat=quaternion(rotation), group=_HIDDEN)
        rangefinder = mjcf.spec.add_sensor(
            name=ray, type=_SENSOR.mjSENS_RANGEFINDER, objtype=_OBJECT.mjOBJ_SITE, objname=ray
        )
        rangefinder.intprm[0] = 1 << int(mujoco.mjtRayDataField.mjRAYDATA_DIST)
        if farthest and 0 < farthest.value < np.inf:
            rangefinder.cutoff = farthest.value
            mjcf.losses.keep(sensor.find(f"{sensor.lidar}/range"), "rangefinders")
            mjcf.losses.keep(sensor.find(f"{sensor.lidar}/range/max"), "cutoff")
    mjcf.losses.keep(sensor.at, "rangefinders")
    for path in (sensor.lidar, scan, f"{scan}/horizontal", f"{scan}/vertical"):
        mjcf.losses.keep(sensor.find(path), "rangefinders")
    for axis, tag in product(("horizontal", "vertical"), ("samples", "min_angle", "max_angle")):
        mjcf.losses.keep(sensor.find(f"{scan}/{axis}/{tag}"), "rangefinders")
    count = len(rows) * len(columns)
    if count < rays:
        note = f"{counted(count, 'rangefinder')} for {rays} rays"
        for axis in ("horizontal", "vertical"):
            mjcf.losses.approximate(sensor.find(f"{scan}/{axis}/samples"), note)


def _angles(sensor: Sensor, path: str, most: int) -> list[float]:
    """Angles of the rays of a scan, in rad."""
    first, last = (sensor.number(f"{path}/{end}_angle") for end in ("min", "max"))
    ends = (first.value if first else 0.0, last.value if last else 0.0)
    count = min(_samples(sensor, path), most)
    return [float(angle) for angle in np.linspace(*ends, count)] if count > 1 else [sum(ends) / 2]


def _samples(sensor: Sensor, path: str) -> int:
    written = sensor.number(f"{path}/samples")
    return max(int(written.value), 1) if written and isfinite(written.value) else 1

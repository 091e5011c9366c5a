"""What MJCF has besides bodies: friction, actuators, sensors, cameras, exclusions."""

from collections.abc import Iterable, Iterator
from math import atan, degrees, tan
from typing import Any

import mujoco

from urdfkit.core.spatial import Rotation, Transform, from_rpy, multiply
from urdfkit.lint.context import Context
from urdfkit.output.conversion.mjcf import COLLISIONS, MjcfRobot, quaternion
from urdfkit.robot.model import Joint
from urdfkit.robot.values import number, numbers
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.ros_control import components, driven_joints
from urdfkit.text.document import Element

#: Gains of actuators for positions, in N·m/rad or N/m, and for velocities, for each N·m or N of
#: effort: a tenth of a radian, or a radian a second, asks for all of it.
POSITION_GAIN, VELOCITY_GAIN = 10.0, 1.0
#: The effort of a joint without a limit, for the gains.
_EFFORT = 100.0

#: Gazebo's cameras look along x and have z up, MuJoCo's along -z and have y up.
_CAMERA: Rotation = ((0.0, 0.0, -1.0), (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0))

_SENSOR, _OBJECT = mujoco.mjtSensor, mujoco.mjtObj
_IMU = (
    ("orientation", _SENSOR.mjSENS_FRAMEQUAT),
    ("angular_velocity", _SENSOR.mjSENS_GYRO),
    ("linear_acceleration", _SENSOR.mjSENS_ACCELEROMETER),
)
_FORCE_TORQUE = (("force", _SENSOR.mjSENS_FORCE), ("torque", _SENSOR.mjSENS_TORQUE))


def add_devices(made: MjcfRobot, robot: Context) -> None:
    """Add friction, actuators, sensors and cameras to a robot."""
    _frictions(made, robot)
    _actuators(made, robot)
    for sensor in sensors(robot.model):
        _sensor(made, robot, sensor)


def _frictions(made: MjcfRobot, robot: Context) -> None:
    """Gazebo's coefficients of friction; MuJoCo has one for both directions."""
    for block in robot.model.gazebo:
        body = made.bodies.get(block.get("reference") or "")
        written = [one for one in block.children if one.tag in ("mu1", "mu2")]
        values = [number(one.text.strip()) for one in written]
        if body is None or not values or values[0] is None or values[0] < 0:
            continue
        for geom in body.geoms:
            if geom.group == COLLISIONS:
                geom.friction[0] = values[0]
        made.losses.keep(block, "body")
        made.losses.keep(written[0], "friction")
        for other, value in zip(written[1:], values[1:], strict=True):
            if value == values[0]:
                made.losses.keep(other, "friction")
            else:
                made.losses.lose(other, "MuJoCo has one coefficient for both directions")


def _actuators(made: MjcfRobot, robot: Context) -> None:
    """One for each joint that does not follow another; motors where nothing says how it moves."""
    commands = dict(_commands(robot))
    for joint in robot.model.joints:
        if joint.mimic or joint.kind not in ("revolute", "continuous", "prismatic"):
            continue
        kind, at = commands.get(joint.name, ("effort", None))
        _actuator(made, joint, kind)
        made.losses.keep(at, f"actuator for {kind}")


def _actuator(made: MjcfRobot, joint: Joint, kind: str) -> None:
    limit = joint.limit
    effort = limit.effort.value if limit and limit.effort and limit.effort.value > 0 else 0.0
    actuator = made.spec.add_actuator(
        name=joint.name, target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT
    )
    if kind == "position":
        gain = POSITION_GAIN * (effort or _EFFORT)
        actuator.set_to_position(kp=gain, dampratio=1.0)
        ends = [one.value for one in (limit.lower, limit.upper) if one] if limit else []
        if len(ends) == 2 and joint.kind != "continuous":
            actuator.ctrllimited, actuator.ctrlrange = True, ends
    elif kind == "velocity":
        actuator.set_to_velocity(kv=VELOCITY_GAIN * (effort or _EFFORT))
        if limit and limit.velocity and limit.velocity.value > 0:
            speed = limit.velocity.value
            actuator.ctrllimited, actuator.ctrlrange = True, (-speed, speed)
            made.losses.keep(limit.at.attributes["velocity"], "ctrlrange of the actuator")
    else:
        actuator.set_to_motor()
        if effort:
            actuator.ctrllimited, actuator.ctrlrange = True, (-effort, effort)


def _commands(robot: Context) -> Iterator[tuple[str, tuple[str, Element]]]:
    """What commands each joint, and the element that says so; the last one counts."""
    for element, transmission in driven_joints(robot.model):
        name = element.get("name") or ""
        interface = element.child("hardwareInterface")
        text = (interface.text if interface else "").lower()
        kind = next((one for one in ("position", "velocity") if one in text), "effort")
        yield name, (kind, interface or transmission)
    for component in components(robot.model):
        for part in component.joints:
            for interface_ in part.of("command"):
                if interface_.name in ("position", "velocity", "effort"):
                    yield part.name, (interface_.name, interface_.at)
                    break


def _sensor(made: MjcfRobot, robot: Context, sensor: Sensor) -> None:
    body = made.bodies.get(sensor.reference)
    if sensor.type in ("imu", "imu_sensor") and body is not None:
        _measured(made, sensor, body, _pose(sensor.at), _IMU)
    elif sensor.type in ("camera", "depth", "rgbd_camera", "depth_camera", "wideanglecamera"):
        if body is not None:
            _camera(made, sensor, body)
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
    name = made.free_name(sensor.name or sensor.reference)
    body.add_site(name=name, pos=at.position, quat=quaternion(at.rotation))
    for what, kind in kinds:
        made.spec.add_sensor(
            name=f"{name}_{what}", type=kind, objtype=_OBJECT.mjOBJ_SITE, objname=name
        )
    made.losses.keep(sensor.at, "site and sensors")
    made.losses.keep(sensor.at.parent, "body")
    made.losses.keep(sensor.at.child("pose"), "site")


def _camera(made: MjcfRobot, sensor: Sensor, body: Any) -> None:
    at = _pose(sensor.at)
    wide = sensor.number("camera/horizontal_fov")
    width, height = sensor.number("camera/image/width"), sensor.number("camera/image/height")
    camera = body.add_camera(
        name=made.free_name(sensor.name or sensor.reference),
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


def exclude_neighbours(made: MjcfRobot, robot: Context) -> None:
    """Exclude pairs of links with a joint between them.

    MuJoCo does so itself, but not where the parent is welded to the world.
    """
    moving = (joint for joint in robot.model.joints if joint.kind != "fixed")
    _exclude(made, {frozenset(robot.tree.ends(joint) or ()) for joint in moving})


def exclude_disabled(made: MjcfRobot, robot: Context) -> None:
    """Exclude pairs of links that the SRDF disables."""
    _exclude(made, robot.srdf.disabled if robot.srdf else ())


def _exclude(made: MjcfRobot, pairs: Iterable[frozenset[str]]) -> None:
    for pair in sorted(map(sorted, set(pairs) - made.excluded)):
        if len(pair) == 2 and all(made.bodies.get(name) is not None for name in pair):
            first, second = (made.bodies[name].name for name in pair)
            if "world" not in (first, second):
                made.spec.add_exclude(name=f"{first} {second}", bodyname1=first, bodyname2=second)
    made.excluded.update(pairs)

"""Drive plugins of Gazebo: the wheels that they drive, and their dimensions."""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from urdfkit.core.record import Record
from urdfkit.core.spatial import Z_AXIS, Transform, Vector, dot, length, minus, rotate, times
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction
from urdfkit.robot.link import Link
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number
from urdfkit.ros.catalog.plugins import Drive
from urdfkit.ros.gazebo.plugins import PluginUse, Reference
from urdfkit.text.document import Attribute, Element

#: Least cosine of the angle between parallel axles.
_PARALLEL = 0.999

#: Least distance in m between left and right wheels.
_MIN_TRACK = 0.01


class Wheel(Record):
    """A wheel in the frame of the root, when all joints are at zero."""

    joint: Joint  # its joint
    axis: Vector  # of the joint, of length 1
    hub: Vector | None  # centre of its tyre; None if the shape is unknown
    radius: float | None  # in m; None if the shape is unknown
    origin: Vector  # of the joint

    @property
    def center(self) -> Vector:
        """Centre of the tyre if its shape is known, else origin of the joint."""
        return self.hub or self.origin

    @property
    def is_at_joint(self) -> bool:
        """False if the distance of tyre and joint exceeds the diameter: one of them is wrong."""
        if self.hub is None or self.radius is None:
            return True
        return length(minus(self.hub, self.origin)) <= 2 * self.radius

    @property
    def is_flat(self) -> bool:
        """True if the joint and the tyre rotate about the vertical."""
        return self.hub is not None and abs(self.axis[2]) >= _PARALLEL

    def is_parallel(self, other: Wheel) -> bool:
        """True if the axes of two wheels are parallel, in either direction."""
        return abs(dot(self.axis, other.axis)) >= _PARALLEL


class DrivenWheel(Record):
    """A wheel that a drive plugin drives."""

    reference: Reference  # the parameter that names its joint
    side: str  # ``left`` or ``right``; empty if the parameter has no side
    wheel: Wheel


def drive_of(use: PluginUse) -> Drive | None:
    """The drive of a plugin; None if the plugin is not a drive."""
    return use.plugin.drive if use.plugin else None


def driven(use: PluginUse) -> list[Reference]:
    """The joints that a plugin moves."""
    if use.plugin is None:
        return []
    names = "*" if use.plugin.drive else use.plugin.moves
    joints = (reference for reference in use.references() if reference.kind == "joint")
    return [joint for joint in joints if names in ("*", joint.parameter.name)]


def wheels(use: PluginUse, tree: KinematicTree) -> Iterator[DrivenWheel]:
    """The wheels of a drive whose joints can rotate."""
    for reference in driven(use):
        joint = tree.model.joints_by_name.get(reference.name)
        name = reference.parameter.name.lower()
        if joint is None or not joint.is_rotational or "steer" in name:
            continue
        side = "left" if "left" in name else "right" if "right" in name else ""
        if wheel := wheel_of(joint, tree):
            yield DrivenWheel(reference, side, wheel)


def wheel_of(joint: Joint, tree: KinematicTree) -> Wheel | None:
    """The wheel that turns about a joint; None if the joint is not in the tree."""
    frame = tree.frames.get(joint.child_name)
    axis = direction(joint)
    if frame is None:
        return None
    hub, radius = _tyre(tree.model.links_by_name[joint.child_name], frame, axis)
    return Wheel(joint, rotate(frame.rotation, axis), hub, radius, frame.position)


def pairs(driven_wheels: list[DrivenWheel]) -> Iterator[tuple[DrivenWheel, DrivenWheel]]:
    """Left and right wheels in the order of their parameters."""
    left = [wheel for wheel in driven_wheels if wheel.side == "left"]
    right = [wheel for wheel in driven_wheels if wheel.side == "right"]
    yield from zip(left, right, strict=False)


def wrong_direction(
    left: Wheel, right: Wheel, effect: str = "the robot turns the wrong way"
) -> tuple[str, str] | None:
    """The reason why a drive does not move a robot as commanded, and the help; None if it does.

    A drive moves forwards by rotating all wheels in the positive direction; the axis of such a
    wheel points to the left.

    Args:
        left: the left wheel according to the drive.
        effect: the effect of swapped sides.
    """
    to_left = dot(minus(left.center, right.center), left.axis)
    if left.is_parallel(right) and left.is_flat:
        message = f"the axis of '{left.joint.name}' is vertical, so the wheel lies flat"
        return message, "write another <axis>, or another rpy in the <origin> of the joint"
    if not left.is_parallel(right) or abs(to_left) < _MIN_TRACK:
        return None
    first, second = f"'{left.joint.name}'", f"'{right.joint.name}'"
    if dot(left.axis, right.axis) < 0:
        message = f"the axes of {first} and {second} are opposite, so the robot spins instead of "
        return f"{message}driving straight", "invert the <axis> of one of the joints"
    if to_left > 0:
        return None
    message = f"left joint {first} is {-to_left:.3g} m to the right of {second} when rolling "
    help = "swap the joints, or invert both axes"
    return f"{message}forwards, so {effect}", help


def wrong_steering(left: Wheel, right: Wheel, rolling: Wheel) -> tuple[str, str] | None:
    """The reason why a drive steers a robot wrongly, and the help; None if it does not.

    Args:
        left: the left steering joint according to the drive.
        rolling: a wheel without steering, which defines the forward direction.
    """
    to_left = dot(minus(left.origin, right.origin), rolling.axis)
    first, second = f"'{left.joint.name}'", f"'{right.joint.name}'"
    if left.axis[2] < 0 and right.axis[2] < 0:
        message = f"the axes of {first} and {second} point down, so the robot steers the wrong way"
        return message, "invert the <axis> of both joints"
    if to_left > -_MIN_TRACK:
        return None
    message = f"left steering joint {first} is {-to_left:.3g} m to the right of {second}"
    return message, "swap the joints"


def metres(use: PluginUse, name: str) -> tuple[Element | Attribute, float] | None:
    """A parameter in m, located at the plugin for a default; None if unreadable.

    Several values, one for each pair of wheels, are unreadable unless they are equal.
    """
    assert use.plugin is not None
    values = use.values(name)
    numbers = {number(item.text) for item in values}
    if values:
        value = numbers.pop()
        return None if value is None or numbers else (values[0].at, value)
    default_parameter = use.plugin.parameters.get(name)
    default = number(default_parameter.default) if default_parameter else None
    return None if default is None else (use.at, default)


def _tyre(link: Link, frame: Transform, axis: Vector) -> tuple[Vector | None, float | None]:
    """Centre and radius of a wheel whose only collision is a sphere, or a cylinder on the axle."""
    if len(link.collisions) != 1:
        return None, None
    body = link.collisions[0]
    shape = body.shape
    if shape is None or shape.kind not in ("cylinder", "sphere") or not shape.radius:
        return None, None
    along = rotate(body.origin.rotation, Z_AXIS)
    if shape.kind == "cylinder" and abs(dot(along, axis)) < _PARALLEL:
        return None, None
    off_axle = minus(body.origin.position, times(axis, dot(body.origin.position, axis)))
    if hypot(*off_axle) > 1e-4:
        return None, None
    return frame.apply(body.origin.position), shape.radius

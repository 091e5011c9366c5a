"""Bounds of placeholder meshes, derived from the other shapes of the link."""

from __future__ import annotations

from math import sqrt

from urdfkit.core.record import Record
from urdfkit.core.spatial import IDENTITY, Z_AXIS, Rotation, Transform, Vector, rotate, transposed
from urdfkit.robot import Robot
from urdfkit.robot.bounding_box import box_of
from urdfkit.robot.kinematics import direction
from urdfkit.robot.link import Body, Link
from urdfkit.robot.shapes import BoundingBox, LinkSolid, Primitive

#: Edges in m outside this range, computed from an inertia tensor, show that the tensor is wrong.
_MIN_EDGE, _MAX_EDGE = 0.001, 3.0
#: Range of edges in m for which solids can be built.
BUILDABLE = (1e-6, 1e4)


class TargetBounds(Record):
    """A box in the frame of a visual or collision."""

    size: Vector  # edges in m, along the columns of ``frame.rotation``
    frame: Transform  # centre and axes
    source: str  # source of the bounds, such as ``the collision``
    measured: bool  # False if they are estimated from mass and inertia


def target_bounds(
    robot: Robot, link: Link, body: Body, axes: Rotation = IDENTITY
) -> TargetBounds | None:
    """The bounds of a shape, from its counterparts in the link, or else from the inertia.

    Args:
        body: the visual or collision.
        axes: axes of the bounds as columns, in the frame of ``body``.
    """
    bodies, source = counterparts(link, body)
    frame = Transform(axes).inverse @ body.origin.inverse
    boxes = [box_of(robot, counterpart, frame) for counterpart in bodies]
    measured = [box for box in boxes if isinstance(box, BoundingBox)]
    if measured and len(measured) == len(bodies):
        return _target_bounds(BoundingBox.around(measured), axes, source, measured=True)
    block = _block_of_inertia(link)
    if block is None:
        return None
    box = LinkSolid((block._replace(origin=frame @ block.origin),)).bounds
    return _target_bounds(box, axes, "mass and inertia", measured=False)


def counterparts(link: Link, body: Body) -> tuple[tuple[Body, ...], str]:
    """The collisions of a link for one of its visuals; the visuals for a collision."""
    if any(body is visual for visual in link.visuals):
        return link.collisions, "the collision"
    return link.visuals, "the visual"


def is_buildable(size: Vector) -> bool:
    """True if a solid with these edges can be built."""
    least, most = BUILDABLE
    return all(least <= edge <= most for edge in size)


def turning_axis(robot: Robot, link: Link, body: Body) -> Vector | None:
    """The rotation axis of a wheel, in the frame of one of its shapes.

    The axis of the only cylinder among the counterparts, or else of the parent joint.
    """
    bodies, _ = counterparts(link, body)
    if len(bodies) == 1 and bodies[0].shape and bodies[0].shape.kind in ("cylinder", "capsule"):
        axis = rotate(bodies[0].origin.rotation, Z_AXIS)
    else:
        joints = robot.tree.parents.get(link.name, [])
        turning = [joint for joint in joints if joint.is_rotational]
        if not turning:
            return None
        axis = direction(turning[0])
    return rotate(transposed(body.origin.rotation), axis)


def _target_bounds(
    box: BoundingBox, axes: Rotation, source: str, *, measured: bool
) -> TargetBounds | None:
    if not is_buildable(box.edges):
        return None
    frame = Transform(axes, rotate(axes, box.center))
    return TargetBounds(box.edges, frame, source, measured)


def _block_of_inertia(link: Link) -> Primitive | None:
    """The box of uniform density with the mass and the moments of a link.

    For the edges a, b, c: ``Ixx = m (b^2 + c^2) / 12`` and so on, so that
    ``a^2 = 6 (Iyy + Izz - Ixx) / m``. None if no box, or no part of a robot, has the tensor.
    """
    inertial = link.inertial
    if inertial is None or inertial.tensor is None or link.mass <= 0:
        return None
    tensor = inertial.tensor.value
    x, y, z = tensor.ixx, tensor.iyy, tensor.izz
    if x == y == z and f"{x:e}".startswith("1.000000e"):
        return None  # placeholders such as 1, 0.1, 0.001
    squares = [6 * value / link.mass for value in (y + z - x, x + z - y, x + y - z)]
    if not all(_MIN_EDGE**2 <= square <= _MAX_EDGE**2 for square in squares):
        return None
    a, b, c = map(sqrt, squares)
    return Primitive("box", (a, b, c), 0.0, 0.0, inertial.origin)

"""The bounds that a placeholder mesh has to fill, by the other shapes of its link."""

from __future__ import annotations

from math import sqrt

from urdfkit.core.record import Record
from urdfkit.core.spatial import IDENTITY, Rotation, Transform, Vector, rotate, transposed
from urdfkit.robot import Robot
from urdfkit.robot.bounding_box import box_of
from urdfkit.robot.kinematics import direction
from urdfkit.robot.model import Body, Link
from urdfkit.robot.shapes import BoundingBox, LinkSolid, Primitive

#: Edges in m outside this range, out of an inertia tensor, say that the tensor is wrong.
_SHORTEST, _LONGEST = 0.001, 3.0
#: Edges in m that solids can be built of.
BUILDABLE = (1e-6, 1e4)


class TargetBounds(Record):
    """A box in the frame of a visual or collision."""

    size: Vector  # its edges in m, along the columns of ``frame.rotation``
    frame: Transform  # its middle and its axes
    source: str  # what it was taken from, such as ``the collision``
    measured: bool  # False if it is only guessed from mass and inertia


def target_bounds(
    robot: Robot, link: Link, body: Body, axes: Rotation = IDENTITY
) -> TargetBounds | None:
    """The bounds of a shape of a link, from its other shapes, else from its inertia.

    Args:
        body: the visual or collision whose bounds are wanted.
        axes: of the bounds, as columns, in the frame of that body.
    """
    others, source = counterparts(link, body)
    frame = Transform(axes).inverse @ body.origin.inverse
    boxes = [box_of(robot, other, frame) for other in others]
    measured = [box for box in boxes if isinstance(box, BoundingBox)]
    if measured and len(measured) == len(others):
        return _target_bounds(BoundingBox.around(measured), axes, source, measured=True)
    block = _block_of_inertia(link)
    if block is None:
        return None
    box = LinkSolid((block._replace(origin=frame @ block.origin),)).bounds
    return _target_bounds(box, axes, "mass and inertia", measured=False)


def counterparts(link: Link, body: Body) -> tuple[tuple[Body, ...], str]:
    """The collisions of a link for one of its visuals, its visuals for a collision."""
    if any(body is visual for visual in link.visuals):
        return link.collisions, "the collision"
    return link.visuals, "the visual"


def is_buildable(size: Vector) -> bool:
    """True for edges of which a solid can be built."""
    least, most = BUILDABLE
    return all(least <= edge <= most for edge in size)


def turning_axis(robot: Robot, link: Link, body: Body) -> Vector | None:
    """The direction that a wheel turns about, in the frame of one of its shapes.

    That of the only cylinder among its shapes, else of the joint that turns it.
    """
    others, _ = counterparts(link, body)
    if len(others) == 1 and others[0].shape and others[0].shape.kind in ("cylinder", "capsule"):
        axis = rotate(others[0].origin.rotation, (0.0, 0.0, 1.0))
    else:
        joints = robot.tree.parents.get(link.name, [])
        turning = [joint for joint in joints if joint.kind in ("continuous", "revolute")]
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
    """The box of uniform density that has the mass and the moments of a link.

    With the edges a, b, c: ``Ixx = m (b^2 + c^2) / 12`` and so on, so that
    ``a^2 = 6 (Iyy + Izz - Ixx) / m``. None where the tensor is no such box, or none of a robot.
    """
    inertial = link.inertial
    if inertial is None or inertial.tensor is None or link.mass <= 0:
        return None
    tensor = inertial.tensor.value
    x, y, z = tensor.ixx, tensor.iyy, tensor.izz
    if x == y == z and f"{x:e}".startswith("1.000000e"):
        return None  # 1, 0.1, 0.001: what people write where they know no value
    squares = [6 * value / link.mass for value in (y + z - x, x + z - y, x + y - z)]
    if not all(_SHORTEST**2 <= square <= _LONGEST**2 for square in squares):
        return None
    a, b, c = map(sqrt, squares)
    return Primitive("box", (a, b, c), 0.0, 0.0, inertial.origin)

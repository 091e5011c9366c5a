"""The room that a mesh has to fill: what the rest of its link tells of its place and size."""

from __future__ import annotations

from collections.abc import Iterable
from math import sqrt
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.core.spatial import IDENTITY, Rotation, Transform, Vector, multiply, rotate, transposed
from urdfkit.robot.model import Body, Link
from urdfkit.robot.shapes import LinkSolid, Primitive, solid

if TYPE_CHECKING:
    from urdfkit.robot import Robot

#: Edges in m outside this range, out of an inertia tensor, say that the tensor is wrong.
_SHORTEST, _LONGEST = 0.001, 3.0


#: Edges in m that solids can be built of.
BUILDABLE = (1e-6, 1e4)


class TargetBounds(Record):
    """A box in the frame of a visual or collision.

    Attributes:
        size: its edges in m, along the columns of ``frame.rotation``.
        frame: its middle and its axes.
        source: what tells it, such as ``the collision``.
        measured: False if it is only guessed from mass and inertia.
    """

    size: Vector
    frame: Transform
    source: str
    measured: bool


def target_bounds(
    robot: Robot, link: Link, body: Body, axes: Rotation = IDENTITY
) -> TargetBounds | None:
    """The room of a shape of a link, from its other shapes, else from its inertia.

    Args:
        robot: the robot.
        link: of it.
        body: the visual or collision whose room is wanted.
        axes: of the room, as columns, in the frame of that body.
    """
    others, source = counterparts(link, body)
    measured = [
        box for box in (_reaches(robot, other, body.origin, axes) for other in others) if box
    ]
    if measured and len(measured) == len(others):
        low = [min(box[0][i] for box in measured) for i in range(3)]
        high = [max(box[1][i] for box in measured) for i in range(3)]
        return _target_bounds(low, high, axes, source, measured=True)
    block = _block_of_inertia(link)
    if block is None:
        return None
    low, high = _bounds(LinkSolid((block,)), body.origin, axes)
    return _target_bounds(low, high, axes, "mass and inertia", measured=False)


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
        direction = rotate(others[0].origin.rotation, (0.0, 0.0, 1.0))
    else:
        joints = robot.tree.parents.get(link.name, [])
        turning = [joint for joint in joints if joint.kind in ("continuous", "revolute")]
        if not turning:
            return None
        direction = turning[0].axis.value if turning[0].axis else (1.0, 0.0, 0.0)
        norm = sqrt(sum(value * value for value in direction))
        if norm == 0:
            return None
        direction = (direction[0] / norm, direction[1] / norm, direction[2] / norm)
    return rotate(transposed(body.origin.rotation), direction)


def _target_bounds(
    low: Iterable[float], high: Iterable[float], axes: Rotation, source: str, *, measured: bool
) -> TargetBounds | None:
    pairs = [*zip(low, high, strict=True)]
    x, y, z = (high - low for low, high in pairs)
    if not is_buildable((x, y, z)):
        return None
    a, b, c = ((low + high) / 2 for low, high in pairs)
    return TargetBounds((x, y, z), Transform(axes, rotate(axes, (a, b, c))), source, measured)


def _reaches(
    robot: Robot, other: Body, frame: Transform, axes: Rotation
) -> tuple[list[float], list[float]] | None:
    """How far a shape reaches along some axes of another one's frame; None if it is not known."""
    whole = solid((other,))
    if whole is not None:
        return _bounds(whole, frame, axes)
    vertices = robot.meshes.vertices(other.shape) if other.shape else None
    if vertices is None or not len(vertices):
        return None
    inverse = transposed(frame.rotation)
    turn = multiply(transposed(axes), multiply(inverse, other.origin.rotation))
    offset = tuple(a - b for a, b in zip(other.origin.position, frame.position, strict=True))
    shift = rotate(multiply(transposed(axes), inverse), (offset[0], offset[1], offset[2]))
    low, high = [], []
    for row, start in zip(turn, shift, strict=True):
        along = vertices @ list(row) + start
        low.append(float(along.min()))
        high.append(float(along.max()))
    return low, high


def _bounds(whole: LinkSolid, frame: Transform, axes: Rotation) -> tuple[list[float], list[float]]:
    """How far a solid reaches along some axes of a frame, from its origin."""
    low, high = [], []
    for column in transposed(axes):
        x, y, z = rotate(frame.rotation, column)
        start = sum(a * b for a, b in zip((x, y, z), frame.position, strict=True))
        low.append(-whole.reach((-x, -y, -z)) - start)
        high.append(whole.reach((x, y, z)) - start)
    return low, high


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

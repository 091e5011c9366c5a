"""Whether bodies of a robot may overlap where it begins, told without any library.

A cautious look at boxes around primitives: most robots without meshes need no more.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import hypot

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, dot, minus
from urdfkit.robot.joints import start_of
from urdfkit.robot.kinematics import frames
from urdfkit.robot.model import Body
from urdfkit.robot.tree import KinematicTree

#: In m: bodies farther apart than this are of no interest.
NEAR = 0.001
#: More bodies are not compared; a humanoid whose meshes are decomposed has half as many.
MAX_BODIES = 2000


class _Box(Record):
    """A box around a body, in the frame of the root."""

    link: str
    frame: Transform
    half: Vector

    @property
    def radius(self) -> float:
        return hypot(*self.half)


def beginning(tree: KinematicTree) -> dict[str, float]:
    """The positions that joints begin at: 0, or the middle of their limits if 0 is beyond them."""
    return {name: start_of(joint) for name, joint in tree.model.joints_by_name.items()}


def may_overlap(tree: KinematicTree) -> bool:
    """True if bodies of two links may overlap, or nearly touch, where the robot begins."""
    with_bodies = [link for link in tree.model.links_by_name.values() if link.collisions]
    if len(with_bodies) < 2:
        return False
    if any(body.shape and body.shape.filename for link in with_bodies for body in link.collisions):
        return True
    placed = frames(tree, beginning(tree))
    boxes = [
        box
        for link in with_bodies
        if link.name in placed
        for body in link.collisions
        if (box := _box(link.name, placed[link.name], body))
    ]
    return len(boxes) > MAX_BODIES or any(
        one.link != other.link and _gap(one, other) < NEAR for one, other in _in_line(boxes)
    )


def _in_line(boxes: list[_Box]) -> Iterator[tuple[_Box, _Box]]:
    """The pairs that are not far apart along the axis on which the boxes are spread most."""
    spread = [
        max(places) - min(places)
        for places in ([box.frame.position[axis] for box in boxes] or [0.0] for axis in range(3))
    ]
    axis = spread.index(max(spread))
    boxes = sorted(boxes, key=lambda box: box.frame.position[axis] - box.radius)
    for number, one in enumerate(boxes):
        end = one.frame.position[axis] + one.radius + NEAR
        for other in boxes[number + 1 :]:
            if other.frame.position[axis] - other.radius > end:
                break
            yield one, other


def _box(link: str, frame: Transform, body: Body) -> _Box | None:
    half = body.shape.half_extents if body.shape else None
    return _Box(link, frame @ body.origin, half) if half else None


def _gap(one: _Box, other: _Box) -> float:
    """A lower bound of the distance of two boxes, in m: along their own axes only."""
    way = minus(other.frame.position, one.frame.position)
    gap = hypot(*way) - one.radius - other.radius
    if gap >= NEAR:
        return gap
    for axis in (*_axes(one.frame), *_axes(other.frame)):
        apart = abs(dot(axis, way)) - _reach(one, axis) - _reach(other, axis)
        gap = max(gap, apart)
    return gap


def _axes(frame: Transform) -> tuple[Vector, ...]:
    """The columns of its rotation."""
    x, y, z = frame.rotation
    return tuple((x[i], y[i], z[i]) for i in range(3))


def _reach(box: _Box, axis: Vector) -> float:
    """How far a box extends from its middle along a unit vector."""
    parts = zip(box.half, _axes(box.frame), strict=True)
    return sum(half * abs(dot(axis, own)) for half, own in parts)

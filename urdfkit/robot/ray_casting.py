"""How far a beam goes inside a primitive, in m."""

from __future__ import annotations

from math import inf, sqrt

from urdfkit.core.spatial import Vector, dot, rotate, transposed
from urdfkit.robot.shapes import Primitive


def exit_from(part: Primitive, start: Vector, direction: Vector) -> float:
    """Where a beam leaves a primitive that it begins in; 0 if it begins outside.

    The round ends of a capsule are left out.

    Args:
        part: convex, as all of them are.
        start: in the frame of the link.
        direction: a unit vector in that frame.
    """
    back = transposed(part.origin.rotation)
    x, y, z = (a - b for a, b in zip(start, part.origin.position, strict=True))
    point, way = rotate(back, (x, y, z)), rotate(back, direction)
    if part.kind == "box":
        a, b, c = part.size
        return max(0.0, _out_of_box(point, way, (a / 2, b / 2, c / 2)))
    if part.kind == "sphere":
        return max(0.0, _out_of_ball(point, way, part.radius))
    across = _out_of_ball((*point[:2], 0.0), (*way[:2], 0.0), part.radius)
    return max(0.0, min(across, _out_of_box(point, way, (inf, inf, part.length / 2))))


def _out_of_box(point: Vector, way: Vector, half: Vector) -> float:
    """Negative outside."""
    found = inf
    for x, v, h in zip(point, way, half, strict=True):
        if abs(x) > h:
            return -inf
        if v:
            found = min(found, ((h if v > 0 else -h) - x) / v)
    return found


def _out_of_ball(point: Vector, way: Vector, radius: float) -> float:
    """Negative outside; infinite for no direction, which is one along the axis of a cylinder."""
    inside = radius * radius - dot(point, point)
    if inside < 0:
        return -inf
    a, b = dot(way, way), dot(point, way)
    return (sqrt(b * b + a * inside) - b) / a if a > 0 else inf

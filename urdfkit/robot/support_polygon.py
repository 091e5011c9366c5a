"""The support polygon of a robot, seen from above; lengths in m."""

from collections.abc import Iterable
from math import atan2, hypot

Point = tuple[float, float]


def hull(points: Iterable[Point]) -> tuple[Point, ...]:
    """The corners of the convex hull, counter-clockwise; fewer than three span no area.

    Source: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions" (1979).
    """
    every = sorted(set(points))
    if len(every) < 3:
        return tuple(every)
    size = max(every[-1][0] - every[0][0], max(y for _, y in every) - min(y for _, y in every))
    least = 1e-9 * size * size  # smaller turns are rounding errors
    lower, upper = _chain(every, least), _chain(every[::-1], least)
    return (*lower[:-1], *upper[:-1])


def _chain(points: list[Point], least: float) -> list[Point]:
    chain: list[Point] = []
    for point in points:
        while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= least:
            chain.pop()
        chain.append(point)
    return chain


def _turn(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def width(polygon: tuple[Point, ...]) -> float:
    """The least distance of two parallel lines that contain a convex polygon."""
    edges = zip(polygon, (*polygon[1:], polygon[0]), strict=True)
    return min(
        max(abs((bx - ax) * (y - ay) - (by - ay) * (x - ax)) for x, y in polygon)
        / hypot(bx - ax, by - ay)
        for (ax, ay), (bx, by) in edges
    )


def weakest_edge(
    polygon: tuple[Point, ...], center: Point, height: float
) -> tuple[float, float, Point]:
    """The weakest edge, as seen from the centre of mass above the polygon.

    Returns:
        The distance, negative outside; the slope in rad at which the robot tips over the edge; and
        the unit vector outwards across it.
    """
    edges: list[tuple[float, Point]] = []
    for (ax, ay), (bx, by) in zip(polygon, (*polygon[1:], polygon[0]), strict=True):
        size = hypot(bx - ax, by - ay)
        outwards = ((by - ay) / size, (ax - bx) / size)
        inside = (ax - center[0]) * outwards[0] + (ay - center[1]) * outwards[1]
        edges.append((inside, outwards))
    margin, direction = min(edges)
    # All edges are equally far below the centre of mass, so that the nearest one is the weakest.
    return margin, atan2(margin, max(height, 0.0)), direction

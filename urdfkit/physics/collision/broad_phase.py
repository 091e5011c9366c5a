"""Broad phase: bodies that may overlap, by bounding spheres and boxes. Lengths in m."""

from collections.abc import Iterable, Iterator, Mapping
from math import dist, hypot

from urdfkit.core.spatial import Transform, minus
from urdfkit.physics.collision.bodies import CollisionBody
from urdfkit.physics.collision.closed_forms import box_distance


def relative(
    first: CollisionBody, second: CollisionBody, frames: Mapping[str, Transform]
) -> Transform:
    """The frame of the second body in the first, from the frames of their links."""
    placed = frames[first.link] @ first.origin
    return placed.inverse @ frames[second.link] @ second.origin


def lower_bound(first: CollisionBody, second: CollisionBody, at: Transform) -> float:
    """A lower bound of the signed distance of two bodies: the distance of their bounding boxes.

    Args:
        at: frame of the second body in the first.
    """
    between = Transform(at.rotation, minus(at.apply(second.center), first.center))
    return box_distance(first.half, second.half, between)


def nearby(
    bodies: Iterable[CollisionBody], frames: Mapping[str, Transform]
) -> Iterator[tuple[CollisionBody, CollisionBody]]:
    """The bodies of different links whose bounding spheres overlap.

    Sweep and prune along the axis of the largest spread.
    """
    spheres = [
        ((frames[body.link] @ body.origin).apply(body.center), hypot(*body.half), body)
        for body in bodies
    ]
    spread = (
        [
            max(center[axis] for center, _, _ in spheres)
            - min(center[axis] for center, _, _ in spheres)
            for axis in range(3)
        ]
        if spheres
        else [0.0]
    )
    axis = spread.index(max(spread))
    spheres.sort(key=lambda sphere: sphere[0][axis] - sphere[1])
    for number, (center, radius, body) in enumerate(spheres):
        for other_center, other_radius, other in spheres[number + 1 :]:
            if other_center[axis] - other_radius > center[axis] + radius:
                break
            if body.link != other.link and dist(center, other_center) < radius + other_radius:
                yield body, other

"""Rays against triangles."""

from collections.abc import Sequence

import numpy as np

from urdfkit.core.spatial import Transform, Vector
from urdfkit.mesh.geometry import Floats, Integers

#: Volume in m^3 below which a ray is parallel to a triangle.
_PARALLEL = 1e-18


def rays_that_hit(
    vertices: Floats,
    faces: Integers,
    at: Transform,
    directions: Sequence[Vector],
    *,
    low: float,
    high: float,
    both_sides: bool,
) -> set[int]:
    """Indices of the rays from the origin that hit a triangle between two ranges.

    Args:
        vertices: (n, 3), in m.
        faces: (m, 3), counter-clockwise from outside.
        at: pose of the frame of the vertices in the frame of the rays.
        directions: unit vectors of the rays.
        low, high: the ranges, in m.
        both_sides: False if only the outside of a triangle stops a ray.

    Source: T. Moeller and B. Trumbore, "Fast, minimum storage ray/triangle intersection" (1997).
    """
    points = vertices @ np.array(at.rotation).T + np.array(at.position)
    rays = np.array(directions)
    if not rays[:, 2].any():  # rays in the plane z = 0 only hit triangles that cross it
        heights = points[:, 2][faces]
        faces = faces[(heights.min(axis=1) <= 0) & (heights.max(axis=1) >= 0)]
    corner, second, third = (points[faces[:, number]] for number in range(3))
    first_edge, second_edge = second - corner, third - corner
    hits: set[int] = set()
    for number, ray in enumerate(rays):
        across = np.cross(ray, second_edge)
        volume = np.einsum("ij,ij->i", first_edge, across)
        facing = (abs(volume) if both_sides else volume) > _PARALLEL
        turned = np.cross(-corner[facing], first_edge[facing])
        u = np.einsum("ij,ij->i", -corner[facing], across[facing]) / volume[facing]
        v = turned @ ray / volume[facing]
        distance = np.einsum("ij,ij->i", second_edge[facing], turned) / volume[facing]
        if ((u >= 0) & (v >= 0) & (u + v <= 1) & (distance >= low) & (distance <= high)).any():
            hits.add(number)
    return hits

"""Rays against triangles."""

from collections.abc import Sequence

import numpy as np

from urdfkit.core.spatial import Transform, Vector
from urdfkit.mesh.geometry import Floats, Integers

#: Volumes in m^3 below which a ray is parallel to a triangle.
_PARALLEL = 1e-18


def rays_that_meet(
    vertices: Floats,
    faces: Integers,
    at: Transform,
    directions: Sequence[Vector],
    *,
    low: float,
    high: float,
    both_sides: bool,
) -> set[int]:
    """The numbers of the rays from the origin that meet a triangle between two ranges.

    Args:
        vertices: (n, 3), in m.
        faces: (m, 3), counter-clockwise from outside.
        at: the frame of the vertices in that of the rays.
        directions: of the rays, of length 1.
        low: the nearest point that counts, in m.
        both_sides: False if a triangle is seen from outside only.

    Source: T. Moeller and B. Trumbore, "Fast, minimum storage ray/triangle intersection" (1997).
    """
    placed = vertices @ np.array(at.rotation).T + np.array(at.position)
    rays = np.array(directions)
    if not rays[:, 2].any():  # all of them lie in a plane: so do the triangles that they meet
        heights = placed[:, 2][faces]
        faces = faces[(heights.min(axis=1) <= 0) & (heights.max(axis=1) >= 0)]
    corner, second, third = (placed[faces[:, number]] for number in range(3))
    one, two = second - corner, third - corner
    found: set[int] = set()
    for number, ray in enumerate(rays):
        across = np.cross(ray, two)
        volume = np.einsum("ij,ij->i", one, across)
        seen = (abs(volume) if both_sides else volume) > _PARALLEL
        turned = np.cross(-corner[seen], one[seen])
        u = np.einsum("ij,ij->i", -corner[seen], across[seen]) / volume[seen]
        v = turned @ ray / volume[seen]
        away = np.einsum("ij,ij->i", two[seen], turned) / volume[seen]
        if ((u >= 0) & (v >= 0) & (u + v <= 1) & (away >= low) & (away <= high)).any():
            found.add(number)
    return found

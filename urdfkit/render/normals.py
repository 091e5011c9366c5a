"""Normals for meshes that come without: smooth where faces meet at a small angle."""

from __future__ import annotations

from math import cos, radians

import numpy as np

from urdfkit.render.arrays import Floats, Integers, cross, dot, unit

#: Faces that meet at a smaller angle are parts of one curved surface.
CREASE = cos(radians(35))
#: Above this number faces are as small as pixels, and flat ones look the same.
MAX_FACES = 250_000
#: Corners at one point are compared in pairs; where more meet, faces stay flat.
MAX_CORNERS = 64


def smooth(vertices: Floats, faces: Integers) -> Floats | None:
    """A normal for each corner, (3 m, 3), in the order of the faces.

    It is the mean of the normals of those faces at the point that belong to one curved surface
    with its own face, weighted by their angles at the point; None if that has no use, since
    all faces are flat or tiny.

    Args:
        vertices: (n, 3); what is at the same place is one point.
        faces: (m, 3).
    """
    if not 0 < len(faces) <= MAX_FACES:
        return None
    points = vertices[faces]
    flat, angles = _flat(points), _angles(points)
    left, right = _pairs(_same_point(points.reshape(-1, 3)))
    face = np.repeat(flat, 3, axis=0)
    joined = dot(face[left], face[right]) > CREASE
    left, right = left[joined], right[joined]
    if np.allclose(face[left], face[right], atol=1e-4):
        return None
    weighted = face * angles.reshape(-1, 1)
    total = weighted.copy()
    for axis in range(3):
        total[:, axis] += np.bincount(left, weighted[right, axis], len(face))
    return unit(total)


def _flat(points: Floats) -> Floats:
    return unit(cross(points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]))


def _angles(points: Floats) -> Floats:
    """The angles of triangles (m, 3, 3) at their corners, (m, 3)."""
    sides = [unit(points[:, (i + 1) % 3] - points[:, i]) for i in range(3)]
    cosines = [-dot(sides[i], sides[(i + 2) % 3]) for i in range(3)]
    return np.arccos(np.clip(np.stack(cosines, axis=1), -1, 1))


def _same_point(points: Floats) -> Integers:
    """Numbers that are equal for equal points."""
    bits = np.ascontiguousarray(points + np.float32(0)).view(np.uint32).astype(np.uint64)
    mixed = bits[:, 0] * np.uint64(0x9E3779B97F4A7C15)
    mixed = (mixed ^ (mixed >> np.uint64(29)) ^ bits[:, 1]) * np.uint64(0xBF58476D1CE4E5B9)
    mixed = (mixed ^ (mixed >> np.uint64(32)) ^ bits[:, 2]) * np.uint64(0x94D049BB133111EB)
    return np.unique(mixed ^ (mixed >> np.uint64(31)), return_inverse=True)[1].reshape(-1)


def _pairs(groups: Integers) -> tuple[Integers, Integers]:
    """Every ordered pair of different members of one group; large groups give none."""
    order = np.argsort(groups, kind="stable")
    sizes = np.bincount(groups)
    starts = np.cumsum(sizes) - sizes
    size, start = sizes[groups[order]], starts[groups[order]]
    partners = np.where(size <= MAX_CORNERS, size, 0)
    left = np.repeat(order, partners)
    along = np.arange(len(left)) - np.repeat(np.cumsum(partners) - partners, partners)
    right = order[np.repeat(start, partners) + along]
    different = left != right
    return left[different], right[different]

"""Triangles of the URDF shapes, with the normals of the exact surface. Lengths in m."""

from functools import cache
from math import pi
from typing import NamedTuple

import numpy as np

from urdfkit.render.arrays import Floats, Integers, unit

#: Sides of a circle, and rings of a hemisphere: visually round at any size.
SIDES, RINGS = 96, 24


class Triangles(NamedTuple):
    """Triangles with vertex normals."""

    vertices: Floats  # (n, 3), in m
    faces: Integers  # (m, 3), indices of vertices, counter-clockwise from outside
    normals: Floats | None = None  # (n, 3), unit vectors; None if every face is flat
    uv: Floats | None = None  # (n, 2), texture coordinates with v upwards; None without them


def box(x: float, y: float, z: float) -> Triangles:
    """A box, centred at the origin; every side shows the whole texture."""
    corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], dtype=np.float32)
    vertices = np.empty((6, 4, 3), dtype=np.float32)
    for side in range(6):
        axis, sign = side % 3, 1 - side // 3 * 2
        vertices[side, :, axis] = sign
        vertices[side, :, (axis + 1) % 3] = corners[:, 0] * sign
        vertices[side, :, (axis + 2) % 3] = corners[:, 1]
    faces = (np.array([(0, 1, 2), (0, 2, 3)]) + 4 * np.arange(6)[:, None, None]).reshape(-1, 3)
    half = np.array((x, y, z), dtype=np.float32) / 2
    uv = np.tile((corners + 1) / 2, (6, 1))
    return Triangles(vertices.reshape(-1, 3) * half, faces.astype(np.int32), None, uv)


def cylinder(radius: float, length: float) -> Triangles:
    return revolved((0, radius, radius, 0), (-length / 2, -length / 2, length / 2, length / 2))


def sphere(radius: float) -> Triangles:
    return capsule(radius, 0.0)


def capsule(radius: float, length: float) -> Triangles:
    """A cylinder of some length along z with a hemisphere at each end."""
    angles = np.linspace(0, pi / 2, RINGS + 1)
    r, z = radius * np.cos(angles), radius * np.sin(angles)
    outline = np.concatenate((r[::-1], r)), np.concatenate((-z[::-1] - length / 2, z + length / 2))
    slopes = np.concatenate((r[::-1], r)), np.concatenate((-z[::-1], z))
    vertices, faces = _lathe(*outline)
    normals, _ = _lathe(*slopes)
    return Triangles(vertices, faces, unit(normals))


def revolved(radii: tuple[float, ...], heights: tuple[float, ...]) -> Triangles:
    """A solid of revolution about z from straight pieces, smooth around z, with edges between."""
    parts = []
    for i in range(len(radii) - 1):
        r, z = np.array(radii[i : i + 2]), np.array(heights[i : i + 2])
        vertices, faces = _lathe(r, z)
        rise, run = z[1] - z[0], r[1] - r[0]
        normals, _ = _lathe(np.array((rise, rise)), np.array((-run, -run)))
        parts.append((vertices, faces + i * len(vertices), unit(normals)))
    vertices, faces, normals = (np.concatenate(column) for column in zip(*parts, strict=True))
    return Triangles(vertices, faces, normals)


def _lathe(radii: Floats, heights: Floats) -> tuple[Floats, Integers]:
    """Vertices and faces of a surface of revolution about z; the outline is from below to above."""
    circle = _circle()
    vertices = np.empty((len(radii), SIDES, 3), dtype=np.float32)
    vertices[:, :, :2] = circle * radii[:, None, None]
    vertices[:, :, 2] = heights[:, None]
    ring = np.arange(SIDES, dtype=np.int32)
    here, there = ring, np.roll(ring, -1)
    above_here, above_there = here + SIDES, there + SIDES
    band = np.stack((here, there, above_there, here, above_there, above_here), axis=1)
    starts = (np.arange(len(radii) - 1, dtype=np.int32) * SIDES)[:, None, None]
    return vertices.reshape(-1, 3), (starts + band).reshape(-1, 3)


@cache
def _circle() -> Floats:
    angles = np.arange(SIDES) * (2 * pi / SIDES)
    return np.stack((np.cos(angles), np.sin(angles)), axis=1).astype(np.float32)

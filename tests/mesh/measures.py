"""Measures of meshes by formulas of their own, as oracles."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.mesh.geometry import Mesh

Point = tuple[float, ...]


def bounds(mesh: Mesh) -> tuple[Point, Point]:
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    return tuple(map(float, low)), tuple(map(float, high))


def volume(mesh: Mesh) -> float:
    """The sum of the tetrahedra between the origin and each triangle."""
    points, total = mesh.vertices.tolist(), 0.0
    for a, b, c in mesh.faces.tolist():
        (x1, y1, z1), (x2, y2, z2), (x3, y3, z3) = points[a], points[b], points[c]
        total += x1 * (y2 * z3 - y3 * z2) + x2 * (y3 * z1 - y1 * z3) + x3 * (y1 * z2 - y2 * z1)
    return total / 6

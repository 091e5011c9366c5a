"""How far beams go until they hit a mesh."""

from __future__ import annotations

import numpy as np

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Floats, Integers

#: Beams within this part of a triangle beside its edge hit it, so that none slips between two.
_EDGE = 1e-9


def first_hits(
    vertices: Floats, faces: Integers, start: Vector, directions: list[Vector], least: float
) -> list[float]:
    """The distance of the nearest triangle on each beam; 0 where there is none.

    Möller and Trumbore, "Fast, minimum storage ray/triangle intersection" (1997).

    Args:
        vertices: (n, 3), in m.
        faces: (m, 3), indices of vertices.
        start: of all beams.
        directions: unit vectors.
        least: hits that are nearer do not count, in m.
    """
    corner, first, second = (vertices[faces[:, number]] for number in range(3))
    first, second, away = first - corner, second - corner, np.asarray(start) - corner
    across = np.cross(away, first)
    with np.errstate(divide="ignore", invalid="ignore"):
        return [
            _first_hit(np.asarray(direction), first, second, away, across, least)
            for direction in directions
        ]


def _first_hit(
    direction: Floats, first: Floats, second: Floats, away: Floats, across: Floats, least: float
) -> float:
    normal = np.cross(direction, second)
    scale = 1 / np.sum(first * normal, axis=1)
    u = np.sum(away * normal, axis=1) * scale
    v = across @ direction * scale
    distance = np.sum(second * across, axis=1) * scale
    hit = (u >= -_EDGE) & (v >= -_EDGE) & (u + v <= 1 + _EDGE) & (distance > least)
    return float(np.min(distance[hit])) if hit.any() else 0.0

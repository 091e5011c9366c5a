"""How far two surfaces are apart."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from urdfkit.meshes.geometry import Floats, Integers

if TYPE_CHECKING:
    from trimesh import Trimesh

#: Points of each surface from which the other one is measured.
MAX_VERTICES, SAMPLES = 1500, 1500
_SEED = 7


def distance(
    vertices: Floats, faces: Integers, other_vertices: Floats, other_faces: Integers
) -> float:
    """The greatest distance from a point of either surface to the other one, in their unit.

    That is the Hausdorff distance, over the vertices (of a large mesh, some of them) and points
    spread over the faces by a fixed seed: never more than the true one, and rarely much less.

    Args:
        vertices: (n, 3).
        faces: (m, 3), indices of vertices.
        other_vertices: of the other surface.
        other_faces: likewise.
    """
    return max(
        one_way(vertices, faces, other_vertices, other_faces),
        one_way(other_vertices, other_faces, vertices, faces),
    )


def one_way(
    vertices: Floats, faces: Integers, other_vertices: Floats, other_faces: Integers
) -> float:
    """The greatest distance from a point of the first surface to the second one.

    Arguments as for `distance`.
    """
    import trimesh

    one = trimesh.Trimesh(vertices, faces, process=False)
    other = trimesh.Trimesh(other_vertices, other_faces, process=False)
    return _farthest(one, other)


def _farthest(one: Trimesh, other: Trimesh) -> float:
    """Of the points of one mesh, the greatest distance to another mesh."""
    import trimesh

    step = max(1, len(one.vertices) // MAX_VERTICES)
    points = [one.vertices[::step]]
    if one.area > 0:
        points.append(trimesh.sample.sample_surface(one, SAMPLES, seed=_SEED)[0])
    query = trimesh.proximity.ProximityQuery(other)
    _, distances, _ = query.on_surface(np.concatenate(points))
    return float(distances.max())

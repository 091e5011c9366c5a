"""Surfaces as solids of manifold3d, which crashes on some open surfaces."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from urdfkit.mesh.edges import Edges, have_distinct_corners
from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.mesh.welding import finite

if TYPE_CHECKING:
    from manifold3d import Manifold
    from numpy.typing import NDArray


def solid(
    points: Floats,
    faces: Integers,
    *,
    numbers: NDArray[np.uint64] | None = None,
    runs: tuple[NDArray[np.uint64], NDArray[np.uint32]] | None = None,
) -> Manifold:
    """The solid that a surface encloses; empty if it is not closed or manifold3d rejects it.

    manifold3d 3 pairs the edges of triangles before it checks that they are pairs, and reads beyond
    its arrays if they are not.

    Args:
        points: (n, 3), welded.
        faces: (m, 3), indices of points.
        numbers: (m,), ids of the faces, which booleans preserve.
        runs: start of each run of faces in the list of corners, followed by the number of corners;
            and the ids of the runs.
    """
    from manifold3d import Manifold, Mesh64

    if not (len(faces) and have_distinct_corners(faces).all() and finite(points).all()):
        return Manifold()
    if Edges(faces).is_unpaired.any():
        return Manifold()
    options = {} if runs is None else {"run_index": runs[0], "run_original_id": runs[1]}
    return Manifold(Mesh64(points, faces.astype(np.uint64), face_id=numbers, **options))

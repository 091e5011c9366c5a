"""Surfaces as solids of manifold3d, which ends the process on some that are none."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from urdfkit.mesh.edges import Edges, three_cornered
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
    """What a surface encloses; empty where it is not closed, or manifold3d does not take it.

    manifold3d 3 pairs the edges of triangles before it has looked whether they are pairs, and reads
    beyond its arrays if not.

    Args:
        points: (n, 3), welded.
        faces: (m, 3), indices of points.
        numbers: (m,), of the faces, which stay with them.
        runs: where in the list of corners each run of faces begins, and at last their number; and
            the ids of the runs.
    """
    from manifold3d import Manifold, Mesh64

    if not (len(faces) and three_cornered(faces).all() and finite(points).all()):
        return Manifold()
    if Edges(faces).is_unpaired.any():
        return Manifold()
    more = {} if runs is None else {"run_index": runs[0], "run_original_id": runs[1]}
    return Manifold(Mesh64(points, faces.astype(np.uint64), face_id=numbers, **more))

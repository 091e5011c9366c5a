"""The pieces of a mesh as solids, and how much of its volume lies in several of them at once."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from urdfkit.meshes.geometry import Floats, Integers
from urdfkit.meshes.pieces import Pieces

if TYPE_CHECKING:
    from manifold3d import Manifold

#: A boolean of more triangles, or of more pieces, takes longer than the rest of the measuring.
MAX_TRIANGLES, MAX_PIECES = 100_000, 500


def overlap(places: Floats, faces: Integers, pieces: Pieces) -> float:
    """The volume that integrals over a surface count more than once, as a part of the true one.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), of a closed surface.
        pieces: of it.

    Returns:
        0 also where that would take long.
    """
    if np.count_nonzero(pieces.volumes > 0) < 2:
        return 0.0
    # manifold3d knows what is small by its number.
    low, high = places.min(axis=0), places.max(axis=0)
    every = bodies((places - low) / (high - low).max(), faces, pieces)
    together = united(every)
    if together is None or not together.volume() > 0:
        return 0.0
    return max(0.0, float(sum(body.volume() for body in every) / together.volume()) - 1)


def bodies(places: Floats, faces: Integers, pieces: Pieces) -> list[Manifold]:
    """The closed pieces that look outwards, as solids; none, where they are too many.

    Arguments as for `overlap`.
    """
    from manifold3d import Manifold, Mesh64

    solid = np.flatnonzero(pieces.is_closed & (pieces.volumes > 0))
    if len(solid) > MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return []
    order = np.argsort(pieces.of_face, kind="stable")
    bounds = np.searchsorted(pieces.of_face[order], [solid, solid + 1]).T
    found = []
    for start, end in bounds:
        used, corners = np.unique(faces[order[start:end]], return_inverse=True)
        found.append(Manifold(Mesh64(places[used], corners.reshape(-1, 3).astype(np.uint64))))
    return found


def united(solids: list[Manifold]) -> Manifold | None:
    """Solids as one; None for none."""
    from manifold3d import Manifold, OpType

    return Manifold.batch_boolean(solids, OpType.Add) if solids else None

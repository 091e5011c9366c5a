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
    if np.count_nonzero(pieces.is_closed & (pieces.volumes > 0)) < 2:
        return 0.0
    # manifold3d knows what is small by its number.
    low, high = places.min(axis=0), places.max(axis=0)
    size = float((high - low).max())
    whole, taken = united((places - low) / size, faces, pieces)
    if whole is None or not whole.volume() > 0:
        return 0.0
    return max(0.0, float(pieces.volumes[taken].sum()) / size**3 / whole.volume() - 1)


def united(
    places: Floats, faces: Integers, pieces: Pieces, parts: Integers | None = None
) -> tuple[Manifold | None, list[int]]:
    """The closed pieces as one solid, and their numbers; None, where they are none or too many.

    From the largest to the smallest, what looks outwards is added, and what looks inwards is taken
    away: it is a cavity, which may hold something again.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), of a surface.
        pieces: of it.
        parts: (m,), numbers that the faces of the solid inherit as ``face_id``.
    """
    from manifold3d import Manifold

    closed = np.flatnonzero(pieces.is_closed & (pieces.volumes != 0))
    if not len(closed) or len(closed) > MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return None, []
    whole, taken = Manifold(), []
    for piece in closed[np.argsort(-np.abs(pieces.volumes[closed]), kind="stable")]:
        own = pieces.of_face == piece
        is_cavity = pieces.volumes[piece] < 0
        corners = faces[own][:, ::-1] if is_cavity else faces[own]
        solid = _solid(places, corners, None if parts is None else parts[own])
        if not solid.is_empty():  # a surface that touches itself may be none
            whole = whole - solid if is_cavity else whole + solid
            taken.append(int(piece))
    return whole, taken


def _solid(places: Floats, faces: Integers, parts: Integers | None = None) -> Manifold:
    """A closed surface, which may have numbers for its faces."""
    from manifold3d import Manifold, Mesh64

    used, corners = np.unique(faces, return_inverse=True)
    numbers = None if parts is None else parts.astype(np.uint64)
    return Manifold(Mesh64(places[used], corners.reshape(-1, 3).astype(np.uint64), face_id=numbers))


def bodies(places: Floats, faces: Integers, pieces: Pieces) -> list[Manifold]:
    """The closed pieces that look outwards, as solids; none, where they are too many.

    Arguments as for `overlap`.
    """
    solid = np.flatnonzero(pieces.is_closed & (pieces.volumes > 0))
    if len(solid) > MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return []
    order = np.argsort(pieces.of_face, kind="stable")
    bounds = np.searchsorted(pieces.of_face[order], [solid, solid + 1]).T
    return [_solid(places, faces[order[start:end]]) for start, end in bounds]

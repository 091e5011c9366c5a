"""The pieces of a mesh as solids, and how much of its volume lies in several of them at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from urdfkit.mesh.components import Pieces
from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.mesh.manifolds import solid

if TYPE_CHECKING:
    from manifold3d import Manifold

#: A boolean of more triangles, or of more pieces, takes longer than the rest of the measuring.
MAX_TRIANGLES, MAX_PIECES = 100_000, 500


def overlap(places: Floats, faces: Integers, pieces: Pieces) -> float:
    """The volume that integrals over a surface count more than once, as a part of the true one.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), of a closed surface.

    Returns:
        0 also where that would take long.
    """
    if np.count_nonzero(pieces.is_closed & (pieces.volumes > 0)) < 2:
        return 0.0
    # manifold3d knows what is small by its number.
    low, high = places.min(axis=0), places.max(axis=0)
    size = float((high - low).max())
    shells = nested((places - low) / size, faces, pieces)
    whole = united(shells)
    if not whole.volume() > 0:
        return 0.0
    counted = sum(-one.solid.volume() if one.is_cavity else one.solid.volume() for one in shells)
    return max(0.0, float(counted / whole.volume()) - 1)


class Shell(NamedTuple):
    """A closed piece: its number, what it encloses, and whether it looks inwards."""

    piece: int
    solid: Manifold
    is_cavity: bool


def nested(
    places: Floats, faces: Integers, pieces: Pieces, parts: Integers | None = None
) -> list[Shell]:
    """The closed pieces, the largest first; none, where they are too many.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), of a surface.
        parts: (m,), numbers that the faces of the solids have as ``face_id``.
    """
    closed = np.flatnonzero(pieces.is_closed & (pieces.volumes != 0))
    if len(closed) > MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return []
    shells = []
    for piece in closed[np.argsort(-np.abs(pieces.volumes[closed]), kind="stable")]:
        own, is_cavity = pieces.of_face == piece, bool(pieces.volumes[piece] < 0)
        corners = faces[own][:, ::-1] if is_cavity else faces[own]
        body = _solid(places, corners, None if parts is None else parts[own])
        if not body.is_empty():  # a surface that touches itself may be none
            shells.append(Shell(int(piece), body, is_cavity))
    return shells


def united(shells: Sequence[Shell]) -> Manifold:
    """Shells as one solid, the largest first: a cavity is taken away, and may hold others."""
    from manifold3d import Manifold

    whole = Manifold()
    for one in shells:
        whole = whole - one.solid if one.is_cavity else whole + one.solid
    return whole


def _solid(places: Floats, faces: Integers, parts: Integers | None = None) -> Manifold:
    """A closed surface, which may have numbers for its faces."""
    used, corners = np.unique(faces, return_inverse=True)
    numbers = None if parts is None else parts.astype(np.uint64)
    return solid(places[used], corners.reshape(-1, 3), numbers=numbers)


def bodies(places: Floats, faces: Integers, pieces: Pieces) -> list[Manifold]:
    """The closed pieces that look outwards, as solids; none, where they are too many.

    Arguments as for `overlap`.
    """
    outward = np.flatnonzero(pieces.is_closed & (pieces.volumes > 0))
    if len(outward) > MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return []
    order = np.argsort(pieces.of_face, kind="stable")
    bounds = np.searchsorted(pieces.of_face[order], [outward, outward + 1]).T
    return [_solid(places, faces[order[start:end]]) for start, end in bounds]

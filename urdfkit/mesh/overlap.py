"""The pieces of a mesh as solids, and the volume that lies in several of them at once."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from urdfkit.mesh.components import Pieces
from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.mesh.manifolds import solid

if TYPE_CHECKING:
    from manifold3d import Manifold

#: Limits above which a boolean takes longer than all other measures.
MAX_TRIANGLES, MAX_PIECES = 100_000, 500


def overlap(places: Floats, faces: Integers, pieces: Pieces) -> float:
    """Volume that integrals over a surface count more than once, as a part of the true volume.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), of a closed surface.

    Returns:
        0 also if the mesh is too large for booleans.
    """
    if np.count_nonzero(pieces.is_closed & (pieces.volumes > 0)) < 2:
        return 0.0
    # manifold3d uses absolute tolerances.
    low, high = places.min(axis=0), places.max(axis=0)
    size = float((high - low).max())
    shells = nested((places - low) / size, faces, pieces)
    union = united(shells)
    if not union.volume() > 0:
        return 0.0
    counted = sum((-1 if part.is_cavity else 1) * part.solid.volume() for part in shells)
    return max(0.0, float(counted / union.volume()) - 1)


def most_overlap(pieces: Pieces) -> float:
    """An upper bound of `overlap`, by the bounding boxes and volumes of pairs of pieces.

    What cavities remove from the union, they remove from the integrals, too. The surfaces must be
    manifold: one that is drawn twice encloses its volume twice.
    """
    solids = pieces.is_closed & (pieces.volumes > 0)
    low, high, volumes = pieces.low[solids], pieces.high[solids], pieces.volumes[solids]
    if len(volumes) > MAX_PIECES:
        return np.inf
    edges = np.minimum(high[:, None], high) - np.maximum(low[:, None], low)
    common = np.minimum(np.maximum(edges, 0).prod(axis=2), np.minimum(volumes[:, None], volumes))
    twice = float(np.triu(common, 1).sum())
    rest = float(pieces.volumes[pieces.is_closed].sum()) - twice
    return twice / rest if rest > 0 else np.inf


class Shell(NamedTuple):
    """A closed piece of a mesh."""

    piece: int  # its number
    solid: Manifold  # enclosed by it
    is_cavity: bool  # True if it faces inwards


def nested(
    places: Floats, faces: Integers, pieces: Pieces, parts: Integers | None = None
) -> list[Shell]:
    """The closed pieces, the largest first; empty if there are too many.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), of a surface.
        parts: (m,), numbers for the ``face_id`` of the faces of the solids.
    """
    closed = np.flatnonzero(pieces.is_closed & (pieces.volumes != 0))
    if len(closed) > MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return []
    shells = []
    for piece in closed[np.argsort(-np.abs(pieces.volumes[closed]), kind="stable")]:
        own, is_cavity = pieces.of_face == piece, bool(pieces.volumes[piece] < 0)
        corners = faces[own][:, ::-1] if is_cavity else faces[own]
        body = _solid(places, corners, None if parts is None else parts[own])
        if not body.is_empty():  # a surface that touches itself may not be a solid
            shells.append(Shell(int(piece), body, is_cavity))
    return shells


def united(shells: Sequence[Shell]) -> Manifold:
    """One solid of shells, the largest first: cavities are subtracted, and may contain solids."""
    from manifold3d import Manifold

    union = Manifold()
    for shell in shells:
        union = union - shell.solid if shell.is_cavity else union + shell.solid
    return union


def _solid(places: Floats, faces: Integers, parts: Integers | None = None) -> Manifold:
    """The solid of a closed surface; ``parts`` are the numbers of its faces."""
    used, corners = np.unique(faces, return_inverse=True)
    numbers = None if parts is None else parts.astype(np.uint64)
    return solid(places[used], corners.reshape(-1, 3), numbers=numbers)


def bodies(places: Floats, faces: Integers, pieces: Pieces) -> list[Manifold]:
    """The closed pieces that face outwards, as solids; empty if there are too many.

    Arguments as for `overlap`.
    """
    outward = np.flatnonzero(pieces.is_closed & (pieces.volumes > 0))
    if len(outward) > MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return []
    order = np.argsort(pieces.of_face, kind="stable")
    bounds = np.searchsorted(pieces.of_face[order], [outward, outward + 1]).T
    return [_solid(places, faces[order[start:end]]) for start, end in bounds]

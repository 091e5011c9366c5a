"""How much of the volume of a mesh lies in several of its pieces at once."""

from __future__ import annotations

import numpy as np

from urdfkit.meshes.geometry import Floats, Integers
from urdfkit.meshes.pieces import Pieces

#: A boolean of more triangles, or of more pieces, takes longer than the rest of the measuring.
MAX_TRIANGLES, MAX_PIECES = 100_000, 500


def overlap(places: Floats, faces: Integers, pieces: Pieces) -> float:
    """The volume that integrals over a surface count more than once, as a part of the true one.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), of a closed surface.
        pieces: of it; those with an inverted surface are cavities, and left out.

    Returns:
        0 also where that would take long.
    """
    solid = np.flatnonzero(pieces.volumes > 0)
    if not 1 < len(solid) <= MAX_PIECES or len(faces) > MAX_TRIANGLES:
        return 0.0
    from manifold3d import Manifold, Mesh64, OpType

    # manifold3d knows what is small by its number.
    low, high = places.min(axis=0), places.max(axis=0)
    scaled = (places - low) / (high - low).max()
    order = np.argsort(pieces.of_face, kind="stable")
    bounds = np.searchsorted(pieces.of_face[order], [solid, solid + 1]).T
    bodies = []
    for start, end in bounds:
        used, corners = np.unique(faces[order[start:end]], return_inverse=True)
        bodies.append(Manifold(Mesh64(scaled[used], corners.reshape(-1, 3).astype(np.uint64))))
    together = Manifold.batch_boolean(bodies, OpType.Add).volume()
    return max(0.0, sum(body.volume() for body in bodies) / together - 1) if together > 0 else 0.0

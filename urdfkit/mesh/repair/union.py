"""Union of overlapping bodies."""

from math import isclose

import numpy as np

from urdfkit.mesh.components import split_pieces
from urdfkit.mesh.edges import Edges
from urdfkit.mesh.overlap import nested, overlap, united
from urdfkit.mesh.repair.soup import TriangleSoup

#: Rounding error of the overlapping part of the volume.
_ROUNDING = 1e-6
#: A piece whose volume changes by more in manifold3d intersects itself, and is not united.
_LOST = 1e-3


def unite(soup: TriangleSoup) -> TriangleSoup:
    """Unite overlapping closed bodies; cavities and open pieces stay.

    Faces keep their part, but lose the reference to their original vertices.
    """
    points, faces = soup.points, soup.faces
    pieces = split_pieces(points, Edges(faces))
    if overlap(points, faces, pieces) <= _ROUNDING:
        return soup
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max())
    shells = [
        shell
        for shell in nested((points - low) / size, faces, pieces, soup.parts)
        if isclose(shell.solid.volume() * size**3, abs(pieces.volumes[shell.piece]), rel_tol=_LOST)
    ]
    mesh = united(shells).to_mesh64()
    new = np.asarray(mesh.tri_verts, dtype=np.int64)
    rest = soup.select(~np.isin(pieces.of_face, [shell.piece for shell in shells]))
    return TriangleSoup(
        np.concatenate([points, low + size * np.asarray(mesh.vert_properties)[:, :3]]),
        np.concatenate([rest.faces, new + len(points)]),
        np.concatenate([rest.corners, np.zeros_like(new)]),
        np.concatenate([rest.parts, np.asarray(mesh.face_id, dtype=np.int64)]),
    )

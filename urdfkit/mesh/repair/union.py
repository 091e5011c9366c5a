"""Bodies that overlap made one."""

from math import isclose

import numpy as np

from urdfkit.mesh.components import take_apart
from urdfkit.mesh.edges import Edges
from urdfkit.mesh.overlap import nested, overlap, united
from urdfkit.mesh.repair.soup import TriangleSoup

#: Less of the volume that counts twice is rounding.
_ROUNDING = 1e-6
#: A piece of which manifold3d keeps less crosses itself, and stays as it is.
_LOST = 1e-3


def unite(soup: TriangleSoup) -> TriangleSoup:
    """The closed bodies as one solid, where they overlap; cavities stay, and what is open, too.

    Faces keep their part; which vertex of the mesh they came from is not known any more.
    """
    if not len(soup.faces):
        return soup
    points, faces = soup.points, soup.faces
    pieces = take_apart(points, Edges(faces))
    if overlap(points, faces, pieces) <= _ROUNDING:
        return soup
    low, size = points.min(axis=0), float(np.ptp(points, axis=0).max())
    shells = [
        one
        for one in nested((points - low) / size, faces, pieces, soup.parts)
        if isclose(one.solid.volume() * size**3, abs(pieces.volumes[one.piece]), rel_tol=_LOST)
    ]
    mesh = united(shells).to_mesh64()
    new = np.asarray(mesh.tri_verts, dtype=np.int64)
    rest = soup.kept(~np.isin(pieces.of_face, [one.piece for one in shells]))
    return TriangleSoup(
        np.concatenate([points, low + size * np.asarray(mesh.vert_properties)[:, :3]]),
        np.concatenate([rest.faces, new + len(points)]),
        np.concatenate([rest.corners, np.zeros_like(new)]),
        np.concatenate([rest.parts, np.asarray(mesh.face_id, dtype=np.int64)]),
    )

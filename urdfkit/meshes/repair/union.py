"""Bodies that overlap made one."""

from __future__ import annotations

import numpy as np

from urdfkit.meshes.edges import Edges
from urdfkit.meshes.overlap import overlap, united
from urdfkit.meshes.pieces import take_apart
from urdfkit.meshes.repair.soup import Soup

#: Less of the volume that counts twice is rounding.
_ROUNDING = 1e-6


def unite(soup: Soup) -> Soup:
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
    whole, taken = united((points - low) / size, faces, pieces, soup.parts)
    if whole is None:
        return soup
    mesh = whole.to_mesh64()
    new = np.asarray(mesh.tri_verts, dtype=np.int64)
    rest = soup.kept(~np.isin(pieces.of_face, taken))
    return Soup(
        np.concatenate([points, low + size * np.asarray(mesh.vert_properties)[:, :3]]),
        np.concatenate([rest.faces, new + len(points)]),
        np.concatenate([rest.corners, np.zeros_like(new)]),
        np.concatenate([rest.parts, np.asarray(mesh.face_id, dtype=np.int64)]),
    )

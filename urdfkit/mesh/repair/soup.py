"""Triangles under repair: welded points, and for each corner the vertex that it came from."""

from __future__ import annotations

import numpy as np

from urdfkit.core.record import Record
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh, MeshPart
from urdfkit.mesh.grouping import distinct
from urdfkit.mesh.welding import weld_finite


class TriangleSoup(Record):
    """Triangles of all parts of a mesh."""

    points: Floats  # (n, 3), no two at the same place
    faces: Integers  # (m, 3), indices of points
    corners: Integers  # (m, 3), indices of the vertices of the mesh that it was made from
    parts: Integers  # (m,), the number of the part that each face belongs to

    def kept(self, which: Flags) -> TriangleSoup:
        return TriangleSoup(self.points, self.faces[which], self.corners[which], self.parts[which])

    def turned(self, which: Flags) -> TriangleSoup:
        faces, corners = self.faces.copy(), self.corners.copy()
        faces[which] = faces[which][:, ::-1]
        corners[which] = corners[which][:, ::-1]
        return self._replace(faces=faces, corners=corners)

    def merged(self, target: Integers) -> TriangleSoup:
        """Replace points by others.

        Args:
            target: (n,), the point that takes the place of each.
        """
        return self._replace(faces=target[self.faces])

    def with_faces(self, faces: Integers, parts: Integers) -> TriangleSoup:
        """More faces of known points; their corners take the attributes of others there."""
        known = np.zeros(len(self.points), dtype=np.int64)
        known[self.faces.reshape(-1)] = self.corners.reshape(-1)
        return TriangleSoup(
            self.points,
            np.concatenate([self.faces, faces]),
            np.concatenate([self.corners, known[faces]]),
            np.concatenate([self.parts, parts]),
        )

    @property
    def size(self) -> float:
        """The diagonal of the bounding box of what is used; 0 for nothing."""
        if not len(self.faces):
            return 0.0
        used = self.points[self.faces.reshape(-1)]
        return float(np.linalg.norm(used.max(axis=0) - used.min(axis=0)))


def soup_of(mesh: Mesh) -> TriangleSoup:
    """The triangles of a mesh; those with a corner that is not finite are left out."""
    vertices, faces = mesh.vertices, mesh.faces
    parts = np.repeat(np.arange(len(mesh.parts)), [len(part.faces) for part in mesh.parts])
    points, welded_faces, good = weld_finite(vertices, faces)
    return TriangleSoup(points, welded_faces, faces[good], parts[good])


def mesh_of(soup: TriangleSoup, mesh: Mesh) -> Mesh:
    """The repaired triangles with the materials of their mesh; normals are left out."""
    starts = np.cumsum([0, *(len(part.vertices) for part in mesh.parts)])
    parts = []
    for number, part in enumerate(mesh.parts):
        mine = soup.parts == number
        if mine.any():
            parts.append(_part(part, soup.kept(mine), int(starts[number])))
    return mesh._replace(parts=tuple(parts))


def _part(part: MeshPart, soup: TriangleSoup, start: int) -> MeshPart:
    plain = part.uv is None and part.colors is None
    looks = np.zeros_like(soup.corners) if plain else soup.corners - start
    # A face that fills a hole between two parts may have a corner of the other one.
    looks = np.where((looks >= 0) & (looks < len(part.vertices)), looks, 0)
    pairs = np.column_stack([soup.faces.reshape(-1), looks.reshape(-1)])
    first, faces, _ = distinct(pairs)
    unique = pairs[first]
    old = unique[:, 1]
    return part._replace(
        vertices=soup.points[unique[:, 0]],
        faces=faces.reshape(-1, 3).astype(np.int64),
        normals=None,
        uv=None if part.uv is None else part.uv[old],
        colors=None if part.colors is None else part.colors[old],
    )

"""Triangles under repair: welded points, and the original vertex of each corner."""

from __future__ import annotations

import numpy as np

from urdfkit.core.record import Record
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh, MeshPart
from urdfkit.mesh.grouping import distinct
from urdfkit.mesh.welding import weld_finite


class TriangleSoup(Record):
    """Triangles of all parts of a mesh."""

    points: Floats  # (n, 3), distinct
    faces: Integers  # (m, 3), indices of points
    corners: Integers  # (m, 3), indices of the vertices of the original mesh
    parts: Integers  # (m,), number of the part that each face belongs to

    def select(self, mask: Flags) -> TriangleSoup:
        return TriangleSoup(self.points, self.faces[mask], self.corners[mask], self.parts[mask])

    def flip(self, mask: Flags) -> TriangleSoup:
        faces, corners = self.faces.copy(), self.corners.copy()
        faces[mask] = faces[mask][:, ::-1]
        corners[mask] = corners[mask][:, ::-1]
        return self._replace(faces=faces, corners=corners)

    def merge(self, target: Integers) -> TriangleSoup:
        """Replace points.

        Args:
            target: (n,), the replacement of each point.
        """
        return self._replace(faces=target[self.faces])

    def with_faces(self, faces: Integers, parts: Integers) -> TriangleSoup:
        """Add faces between existing points, whose corners take existing vertex attributes."""
        vertex_at = np.zeros(len(self.points), dtype=np.int64)
        vertex_at[self.faces.reshape(-1)] = self.corners.reshape(-1)
        return TriangleSoup(
            self.points,
            np.concatenate([self.faces, faces]),
            np.concatenate([self.corners, vertex_at[faces]]),
            np.concatenate([self.parts, parts]),
        )

    @property
    def size(self) -> float:
        """Diagonal of the bounding box of all faces; 0 without faces."""
        if not len(self.faces):
            return 0.0
        used = self.points[self.faces.reshape(-1)]
        return float(np.linalg.norm(used.max(axis=0) - used.min(axis=0)))


def soup_of(mesh: Mesh) -> TriangleSoup:
    """The triangles of a mesh, except those with a non-finite corner."""
    vertices, faces = mesh.vertices, mesh.faces
    parts = np.repeat(np.arange(len(mesh.parts)), [len(part.faces) for part in mesh.parts])
    points, welded_faces, good = weld_finite(vertices, faces)
    return TriangleSoup(points, welded_faces, faces[good], parts[good])


def mesh_of(soup: TriangleSoup, mesh: Mesh) -> Mesh:
    """The repaired triangles with the materials of their mesh, without normals."""
    starts = np.cumsum([0, *(len(part.vertices) for part in mesh.parts)])
    parts = []
    for number, part in enumerate(mesh.parts):
        in_part = soup.parts == number
        if in_part.any():
            parts.append(_part(part, soup.select(in_part), int(starts[number])))
    return mesh._replace(parts=tuple(parts))


def _part(part: MeshPart, soup: TriangleSoup, start: int) -> MeshPart:
    plain = part.uv is None and part.colors is None
    vertices = np.zeros_like(soup.corners) if plain else soup.corners - start
    # A face that fills a hole between two parts may have a corner of the other part.
    vertices = np.where((vertices >= 0) & (vertices < len(part.vertices)), vertices, 0)
    pairs = np.column_stack([soup.faces.reshape(-1), vertices.reshape(-1)])
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

"""Topology and defects of a mesh, as numbers."""

from __future__ import annotations

import numpy as np

from urdfkit.core.record import Record
from urdfkit.mesh.components import inside_out, split_pieces
from urdfkit.mesh.edges import Edges, have_distinct_corners
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh
from urdfkit.mesh.grouping import distinct
from urdfkit.mesh.measures import OVERLAP
from urdfkit.mesh.overlap import overlap
from urdfkit.mesh.welding import weld, weld_finite


class Health(Record):
    """The state of a mesh after its vertices are welded."""

    faces: int  # number of triangles
    non_finite: int  # triangles with a corner that is nan or infinite
    collapsed: int  # triangles with two corners at the same position
    repeated: int  # triangles that repeat another one with the same orientation
    open_edges: int  # edges with one triangle: the boundaries of holes
    #: Edges with more than two triangles that do not pair up; where bodies touch, they do.
    non_manifold_edges: int
    inconsistent_edges: int  # edges whose two triangles have opposite orientation
    bodies: int  # connected pieces
    inverted: int  # closed pieces that face inwards and are not inside another piece
    #: Triangles of closed pieces without volume: a two-sided sheet has each triangle in both
    #: orientations.
    doubled: int
    volume: float  # in the cube of the mesh's unit; meaningless unless the mesh is a solid
    #: Volume inside several closed pieces at once, which counts as often in ``volume``, as a part
    #: of the true volume; only `examine_mesh` computes it.
    overlap: float = 0.0

    @property
    def is_closed(self) -> bool:
        """True if the mesh has neither holes nor non-manifold edges."""
        return self.faces > 0 and not (self.open_edges or self.non_manifold_edges)

    @property
    def is_solid(self) -> bool:
        """True if the mesh is the surface of a solid.

        It is closed and faces outwards, and its pieces hardly overlap.
        """
        return self.faces > 0 and self.volume > 0 and not self.defects and self.overlap <= OVERLAP

    @property
    def defects(self) -> int:
        """Number of all defects, for comparisons."""
        return (
            self.non_finite
            + self.collapsed
            + self.repeated
            + self.open_edges
            + self.non_manifold_edges
            + self.inconsistent_edges
            + self.inverted
            + self.doubled
        )


def examine_mesh(mesh: Mesh) -> Health:
    """The state of a mesh with its parts.

    A part may be a separate solid that touches others, as in an assembly, or one colour of a larger
    surface; the interpretation with fewer defects is used.
    """
    joined = examine(mesh.vertices, mesh.faces)
    if joined.defects == 0:
        return joined._replace(overlap=_overlap(*weld(mesh.vertices, mesh.faces)))
    if len(mesh.parts) < 2:
        return joined
    separate = _examine([(part.vertices, part.faces) for part in mesh.parts])
    if separate.defects >= joined.defects:
        return joined
    if separate.defects:
        return separate
    welded = _joined([weld(part.vertices, part.faces) for part in mesh.parts])
    return separate._replace(overlap=_overlap(*welded))


def _overlap(points: Floats, faces: Integers) -> float:
    return overlap(points, faces, split_pieces(points, Edges(faces))) if len(faces) else 0.0


def _joined(parts: list[tuple[Floats, Integers]]) -> tuple[Floats, Integers]:
    """The vertices and triangles of all parts, which share no vertex."""
    starts = np.cumsum([0, *(len(points) for points, _ in parts[:-1])])
    faces = [faces + start for (_, faces), start in zip(parts, starts, strict=True)]
    return np.concatenate([points for points, _ in parts]), np.concatenate(faces)


def examine(vertices: Floats, faces: Integers) -> Health:
    """Examine whether a mesh is closed, consistently oriented and free of defects.

    Args:
        vertices: (n, 3).
        faces: (m, 3), indices of vertices.
    """
    return _examine([(vertices, faces)])


def _examine(parts: list[tuple[Floats, Integers]]) -> Health:
    """Examine separate parts together: thousands of parts take as long as one."""
    number = sum(len(faces) for _, faces in parts)
    welded_parts = [weld_finite(*part)[:2] for part in parts]
    points, welded = _joined(welded_parts)
    of_part = np.repeat(np.arange(len(parts)), [len(faces) for _, faces in welded_parts])
    sound = have_distinct_corners(welded)
    non_finite, collapsed = number - len(welded), _count(~sound)
    welded = welded[sound]
    if not len(welded):
        return Health(number, non_finite, collapsed, 0, 0, 0, 0, 0, 0, 0, 0.0)
    edges = Edges(welded)
    pieces = split_pieces(points, edges)
    inverted = inside_out(points, welded, pieces, of_part=of_part[sound])
    return Health(
        number,
        non_finite,
        collapsed,
        _repeated(welded),
        _count(edges.is_open),
        _count(edges.is_unmatched),
        _count(edges.is_inconsistent),
        len(pieces.volumes),
        _count(inverted),
        _count(pieces.is_hollow[pieces.of_face]),
        float(pieces.volumes.sum()),
    )


def _count(flags: Flags) -> int:
    return int(np.count_nonzero(flags))


def _repeated(faces: Integers) -> int:
    """Number of faces that repeat another one with the same orientation."""
    turned = np.argmin(faces, axis=1)[:, None] + np.arange(3)
    rows = np.take_along_axis(faces, turned % 3, axis=1)
    return len(faces) - len(distinct(rows)[0])

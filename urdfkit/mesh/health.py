"""What is right and wrong with the triangles of a mesh, as numbers."""

from __future__ import annotations

import numpy as np

from urdfkit.core.record import Record
from urdfkit.mesh.components import inside_out, take_apart
from urdfkit.mesh.edges import Edges, three_cornered
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh
from urdfkit.mesh.grouping import distinct
from urdfkit.mesh.measures import OVERLAP
from urdfkit.mesh.overlap import overlap
from urdfkit.mesh.welding import weld, weld_finite


class Health(Record):
    """The state of a mesh, its vertices welded where they are at the same place."""

    faces: int  # number of triangles
    non_finite: int  # triangles with a corner that is nan or infinite
    collapsed: int  # triangles with two corners in one place
    repeated: int  # triangles that are there already, the same way round
    open_edges: int  # edges with one triangle: the rims of holes
    #: Edges with more than two triangles that do not pair up; where bodies touch, they do.
    non_manifold_edges: int
    inconsistent_edges: int  # edges whose two triangles have opposite orientation
    bodies: int  # connected pieces
    inverted: int  # closed pieces whose inside is out, though no other piece is around them
    #: Triangles of closed pieces that enclose nothing: a sheet with two sides has each triangle
    #: both ways round.
    doubled: int
    volume: float  # in the cube of the mesh's unit; a number without meaning unless it is a solid
    #: What lies in several closed pieces at once and counts as often in the volume, as a part of
    #: the true one; only `examine_mesh` looks for it.
    overlap: float = 0.0

    @property
    def is_closed(self) -> bool:
        """True if it has no holes and no edge with more than two triangles."""
        return self.faces > 0 and not (self.open_edges or self.non_manifold_edges)

    @property
    def is_solid(self) -> bool:
        """True if it is the surface of a solid.

        It is closed, outside is outside everywhere, and hardly anything is in several pieces.
        """
        return self.faces > 0 and self.volume > 0 and not self.defects and self.overlap <= OVERLAP

    @property
    def defects(self) -> int:
        """How much is wrong, as one number to compare by."""
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

    A part may be a solid of its own that touches others, as in an assembly, or one colour of the
    surface of a whole: that reading is taken in which less is wrong.
    """
    whole = examine(mesh.vertices, mesh.faces)
    if whole.defects == 0:
        return whole._replace(overlap=_overlap(*weld(mesh.vertices, mesh.faces)))
    if len(mesh.parts) < 2:
        return whole
    parts = [examine(part.vertices, part.faces) for part in mesh.parts]
    together = Health(*(sum(values) for values in zip(*parts, strict=True)))
    if together.defects >= whole.defects:
        return whole
    return together._replace(overlap=_overlap(*_apart(mesh)) if not together.defects else 0.0)


def _overlap(points: Floats, faces: Integers) -> float:
    return overlap(points, faces, take_apart(points, Edges(faces))) if len(faces) else 0.0


def _apart(mesh: Mesh) -> tuple[Floats, Integers]:
    """The triangles of all parts, each part welded by itself."""
    parts = [weld(part.vertices, part.faces) for part in mesh.parts]
    starts = np.cumsum([0, *(len(points) for points, _ in parts[:-1])])
    faces = [faces + start for (_, faces), start in zip(parts, starts, strict=True)]
    return np.concatenate([points for points, _ in parts]), np.concatenate(faces)


def examine(vertices: Floats, faces: Integers) -> Health:
    """Examine whether a mesh is closed, consistently oriented and free of defects.

    Args:
        vertices: (n, 3).
        faces: (m, 3), indices of vertices.
    """
    number = len(faces)
    points, kept, good = weld_finite(vertices, faces)
    sound = three_cornered(kept)
    non_finite, collapsed = number - int(good.sum()), _count(~sound)
    kept = kept[sound]
    if not len(kept):
        return Health(number, non_finite, collapsed, 0, 0, 0, 0, 0, 0, 0, 0.0)
    edges = Edges(kept)
    pieces = take_apart(points, edges)
    return Health(
        number,
        non_finite,
        collapsed,
        _repeated(kept),
        _count(edges.is_open),
        _count(edges.is_unmatched),
        _count(edges.is_inconsistent),
        len(pieces.volumes),
        _count(inside_out(points, kept, pieces)),
        _count(pieces.is_hollow[pieces.of_face]),
        float(pieces.volumes.sum()),
    )


def _count(flags: Flags) -> int:
    return int(np.count_nonzero(flags))


def _repeated(faces: Integers) -> int:
    """How many faces are there already, the same way round."""
    turned = np.argmin(faces, axis=1)[:, None] + np.arange(3)
    rows = np.take_along_axis(faces, turned % 3, axis=1)
    return len(faces) - len(distinct(rows)[0])

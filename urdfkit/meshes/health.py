"""What is right and wrong with the triangles of a mesh, as numbers."""

from __future__ import annotations

import numpy as np

from urdfkit.meshes.edges import Edges, distinct, finite, volumes, welded
from urdfkit.meshes.geometry import Flags, Floats, Integers, Mesh
from urdfkit.record import Record


class Health(Record):
    """The state of a mesh, its vertices welded where they are at the same place.

    Attributes:
        faces: number of triangles.
        non_finite: triangles with a corner that is nan or infinite.
        collapsed: triangles with two corners in one place.
        repeated: triangles that are there already, the same way round.
        open_edges: edges with one triangle: the rims of holes.
        crowded_edges: edges with more than two triangles that do not pair up. Where bodies touch,
            they do.
        twisted_edges: edges whose two triangles face opposite ways.
        bodies: connected pieces.
        inverted: closed pieces whose inside is out, though no other piece is around them.
        volume: in the cube of the mesh's unit; a number without meaning unless it is a solid.
    """

    faces: int
    non_finite: int
    collapsed: int
    repeated: int
    open_edges: int
    crowded_edges: int
    twisted_edges: int
    bodies: int
    inverted: int
    volume: float

    @property
    def is_closed(self) -> bool:
        """True if it has no holes and no edge with more than two triangles."""
        return self.faces > 0 and not (self.open_edges or self.crowded_edges)

    @property
    def is_solid(self) -> bool:
        """True if it is the surface of a solid: closed, and outside is outside everywhere."""
        return self.faces > 0 and self.volume > 0 and self.ailments == 0

    @property
    def ailments(self) -> int:
        """How much is wrong, as one number to compare by."""
        return (
            self.non_finite
            + self.collapsed
            + self.repeated
            + self.open_edges
            + self.crowded_edges
            + self.twisted_edges
            + self.inverted
        )


def examine_mesh(mesh: Mesh) -> Health:
    """The state of a mesh with its parts.

    A part may be a solid of its own that touches others, as in an assembly, or one colour of the
    surface of a whole: that reading is taken in which less is wrong.
    """
    whole = examine(mesh.vertices, mesh.faces)
    if whole.ailments == 0 or len(mesh.parts) < 2:
        return whole
    parts = [examine(part.vertices, part.faces) for part in mesh.parts]
    together = Health(*(sum(values) for values in zip(*parts, strict=True)))
    return together if together.ailments < whole.ailments else whole


def examine(vertices: Floats, faces: Integers) -> Health:
    """The state of a mesh.

    Args:
        vertices: (n, 3).
        faces: (m, 3), indices of vertices.
    """
    number = len(faces)
    is_finite = finite(vertices)
    good = is_finite[faces].all(axis=1)
    points, kept = welded(np.where(is_finite[:, None], vertices, 0.0), faces[good])
    a, b, c = kept.T
    collapsed = (a == b) | (b == c) | (c == a)
    kept = kept[~collapsed]
    if not len(kept):
        return Health(number, number - int(good.sum()), int(collapsed.sum()), 0, 0, 0, 0, 0, 0, 0.0)
    edges = Edges(kept)
    return Health(
        number,
        number - int(good.sum()),
        int(collapsed.sum()),
        _repeated(kept),
        int(edges.is_open.sum()),
        int(edges.is_torn.sum()),
        int(edges.is_twisted.sum()),
        int(edges.bodies.max()) + 1,
        int(inside_out(points, kept, edges).sum()),
        float(volumes(points, kept, np.zeros(len(kept), dtype=np.int64))[0]),
    )


def _repeated(faces: Integers) -> int:
    """How many faces are there already, the same way round."""
    turned = np.argmin(faces, axis=1)[:, None] + np.arange(3)
    rows = np.take_along_axis(faces, turned % 3, axis=1)
    return len(faces) - len(distinct(rows)[0])


def inside_out(points: Floats, faces: Integers, edges: Edges) -> Flags:
    """(bodies,), True for a closed body of negative volume that lies in no other body.

    A body in another one may be a hole in it, which is meant to be inside out.
    """
    signed = volumes(points, faces, edges.bodies)
    is_open = np.zeros(len(signed), dtype=bool)
    is_open[edges.bodies[~(edges.count[edges.of_face] == 2).all(axis=1)]] = True
    suspects = np.flatnonzero((signed < 0) & ~is_open)
    found = np.zeros(len(signed), dtype=bool)
    for body in suspects:
        corner = points[faces[edges.bodies == body][0, 0]]
        found[body] = not any(
            contains(points, faces[edges.bodies == other], corner)
            for other in range(len(signed))
            if other != body and not is_open[other] and abs(signed[other]) > abs(signed[body])
        )
    return found


def contains(points: Floats, faces: Integers, point: Floats) -> bool:
    """True if a closed surface goes around a point (its solid angle is not zero).

    Source: A. Van Oosterom, J. Strackee, "The solid angle of a plane triangle", IEEE Trans.
    Biomed. Eng. 30 (1983).
    """
    low, high = points[faces].min(axis=(0, 1)), points[faces].max(axis=(0, 1))
    if (point < low).any() or (point > high).any():
        return False
    a, b, c = (points[faces[:, i]] - point for i in range(3))
    la, lb, lc = (np.linalg.norm(vectors, axis=1) for vectors in (a, b, c))
    triple = (a * np.cross(b, c)).sum(axis=1)
    rest = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
    return bool(abs(np.arctan2(triple, rest).sum()) > np.pi)  # half of 4 pi, halved once more

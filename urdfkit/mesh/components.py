"""The connected pieces of a mesh: their volumes, which are flat, and which face inwards."""

from typing import NamedTuple

import numpy as np

from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Flags, Floats, Integers, scaled_normals

#: Volume, relative to the cube of a piece's diagonal, that counts as zero.
ROUNDING = 1e-7


class Pieces(NamedTuple):
    """The edge-connected pieces of a mesh."""

    of_face: Integers  # (m,), number of the piece that each triangle belongs to
    volumes: Floats  # (p,), signed; meaningless for an open piece
    #: low and high: (p, 3), corners of the bounding boxes.
    low: Floats
    high: Floats
    is_closed: Flags  # (p,), True if every edge has as many triangles in one direction as the other

    @property
    def is_hollow(self) -> Flags:
        """(p,), True for a closed piece without volume, such as a two-sided sheet."""
        size = np.linalg.norm(self.high - self.low, axis=1)
        return np.asarray(self.is_closed & (np.abs(self.volumes) <= ROUNDING * size**3))

    def corners(self, places: Floats, faces: Integers) -> Floats:
        """(p, 3), a vertex of each piece."""
        _, first = np.unique(self.of_face, return_index=True)
        return np.asarray(places[faces[first, 0]])


def split_pieces(places: Floats, edges: Edges) -> Pieces:
    """Split a mesh into its connected pieces.

    Args:
        places: (n, 3), welded.
        edges: of faces with three distinct corners.
    """
    faces, of_face = edges.faces, edges.bodies
    number = int(of_face.max(initial=-1)) + 1
    corners = places.take(faces.T, axis=0)
    low, high = _extents(corners, of_face, number)
    corners -= ((low + high) / 2)[of_face]
    a, b, c = corners
    volumes = np.bincount(of_face, np.einsum("ij,ij->i", a, np.cross(b, c)), number) / 6
    is_closed = np.ones(number, dtype=bool)
    is_closed[of_face[edges.is_unpaired[edges.of_face].any(axis=1)]] = False
    return Pieces(of_face, volumes, low, high, is_closed)


def _extents(corners: Floats, of_face: Integers, number: int) -> tuple[Floats, Floats]:
    """Bounding boxes of pieces from the corners of their faces, (3, m, 3)."""
    low, high = np.full((number, 3), np.inf), np.full((number, 3), -np.inf)
    least, most = corners.min(axis=0), corners.max(axis=0)
    for axis in range(3):  # four times as fast as all axes at once
        np.minimum.at(low[:, axis], of_face, least[:, axis])
        np.maximum.at(high[:, axis], of_face, most[:, axis])
    return low, high


def are_flat(
    places: Floats, faces: Integers, areas: Floats, pieces: Pieces, thickness: float
) -> Flags:
    """(p,), True for closed pieces that lie in the plane of their largest triangle.

    Args:
        places: (n, 3).
        faces: (m, 3).
        areas: (m,), of the faces.
    """
    # A surface whose points are less than the thickness from a plane encloses at most this volume.
    most = thickness * np.bincount(pieces.of_face, areas, len(pieces.volumes))
    is_flat = np.asarray(pieces.is_closed & (np.abs(pieces.volumes) <= 2 * most))
    if is_flat.any():
        own = is_flat[pieces.of_face]
        of_face = (np.cumsum(is_flat) - 1)[pieces.of_face[own]]
        is_flat[is_flat] = _farthest(places[faces[own]], of_face) <= thickness
    return is_flat


def _farthest(corners: Floats, of_face: Integers) -> Floats:
    """(p,), distance of the points of each piece from the plane of its largest triangle."""
    number = int(of_face.max()) + 1
    normals = scaled_normals(corners)
    areas = np.einsum("ij,ij->i", normals, normals)
    order = np.lexsort((areas, of_face))
    largest = order[np.searchsorted(of_face[order], np.arange(number), side="right") - 1]
    length = np.sqrt(areas[largest])
    normal = normals[largest] / np.where(length > 0, length, 1)[:, None]
    distances = np.abs(
        np.einsum("fcj,fj->fc", corners - corners[largest, 0][of_face][:, None], normal[of_face])
    )
    farthest = np.zeros(number)
    np.maximum.at(farthest, of_face, distances.max(axis=1))
    return farthest


def inside_out(
    places: Floats,
    faces: Integers,
    pieces: Pieces,
    least: float = 0.0,
    of_part: Integers | None = None,
) -> Flags:
    """(p,), True for closed pieces that face inwards and do not lie in another closed piece.

    A piece inside another may be a cavity, whose normals point inwards. A two-sided surface, as
    from SketchUp, has no volume and no inside.

    Args:
        places: (n, 3).
        faces: (m, 3).
        least: volume up to which a piece is ignored.
        of_part: (m,), the part of the mesh of each face; pieces of other parts are ignored.
    """
    is_inverted = np.zeros(len(pieces.volumes), dtype=bool)
    part = np.zeros(len(pieces.volumes), dtype=np.int64)
    if of_part is not None:
        part[pieces.of_face] = of_part
    corners = pieces.corners(places, faces)
    rounding = ROUNDING * np.linalg.norm(pieces.high - pieces.low, axis=1) ** 3
    for piece in np.flatnonzero(pieces.is_closed & (pieces.volumes < -np.maximum(least, rounding))):
        around = ~pieces.is_closed | (np.abs(pieces.volumes) > abs(pieces.volumes[piece]))
        around &= part == part[piece]
        around &= (pieces.low <= pieces.low[piece]).all(axis=1)
        around &= (pieces.high >= pieces.high[piece]).all(axis=1)
        is_inverted[piece] = not any(
            contains(places, faces[pieces.of_face == other], corners[piece])
            for other in np.flatnonzero(around)
        )
    return is_inverted


def contains(points: Floats, faces: Integers, point: Floats) -> bool:
    """True if a closed surface contains a point (its solid angle is not zero).

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

"""The pieces of a mesh: what each encloses, which are flat, and which look inwards."""

from typing import NamedTuple

import numpy as np

from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Flags, Floats, Integers

#: A volume that is so small against the cube of a piece's diagonal is none.
ROUNDING = 1e-7


class Pieces(NamedTuple):
    """The pieces of a mesh that edges hold together."""

    of_face: Integers  # (m,), the number of the piece that each triangle belongs to
    volumes: Floats  # (p,), signed; without meaning for one that is open
    #: low and high: (p, 3), the corners of the bounding box of each.
    low: Floats
    high: Floats
    is_closed: Flags  # (p,), True where every edge has as many triangles one way as the other

    @property
    def is_hollow(self) -> Flags:
        """(p,), True for a closed piece that encloses nothing, such as a sheet with two sides."""
        size = np.linalg.norm(self.high - self.low, axis=1)
        return np.asarray(self.is_closed & (np.abs(self.volumes) <= ROUNDING * size**3))

    def corners(self, places: Floats, faces: Integers) -> Floats:
        """(p, 3), a vertex of each piece."""
        _, first = np.unique(self.of_face, return_index=True)
        return np.asarray(places[faces[first, 0]])


def take_apart(places: Floats, edges: Edges) -> Pieces:
    """Split a mesh into its connected pieces.

    Args:
        places: (n, 3), welded.
        edges: of faces that have three corners each.
    """
    faces, of_face = edges.faces, edges.bodies
    number = int(of_face.max(initial=-1)) + 1
    corners = places[faces.T]
    low, high = _extents(corners, of_face, number)
    corners -= ((low + high) / 2)[of_face]
    a, b, c = corners
    volumes = np.bincount(of_face, np.einsum("ij,ij->i", a, np.cross(b, c)), number) / 6
    is_closed = np.ones(number, dtype=bool)
    is_closed[of_face[edges.is_unpaired[edges.of_face].any(axis=1)]] = False
    return Pieces(of_face, volumes, low, high, is_closed)


def _extents(corners: Floats, of_face: Integers, number: int) -> tuple[Floats, Floats]:
    """The bounding boxes of pieces with corners of faces, (3, m, 3)."""
    low, high = np.full((number, 3), np.inf), np.full((number, 3), -np.inf)
    least, most = corners.min(axis=0), corners.max(axis=0)
    for axis in range(3):  # all at once takes numpy four times as long
        np.minimum.at(low[:, axis], of_face, least[:, axis])
        np.maximum.at(high[:, axis], of_face, most[:, axis])
    return low, high


def are_flat(places: Floats, faces: Integers, pieces: Pieces, thickness: float) -> Flags:
    """(p,), whether each piece lies in a plane: that of its largest triangle."""
    of_face, number = pieces.of_face, len(pieces.volumes)
    corners = places[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    areas = np.einsum("ij,ij->i", normals, normals)
    order = np.lexsort((areas, of_face))
    largest = order[np.searchsorted(of_face[order], np.arange(number), side="right") - 1]
    length = np.sqrt(areas[largest])
    normal = normals[largest] / np.where(length > 0, length, 1)[:, None]
    away = np.abs(
        np.einsum("fcj,fj->fc", corners - corners[largest, 0][of_face][:, None], normal[of_face])
    )
    farthest = np.zeros(number)
    np.maximum.at(farthest, of_face, away.max(axis=1))
    flat: Flags = farthest <= thickness
    return flat


def inside_out(places: Floats, faces: Integers, pieces: Pieces, least: float = 0.0) -> Flags:
    """(p,), whether a closed piece looks inwards and lies in no other closed one.

    A piece in another one may be a hole in it, whose normals point inwards. A surface that is
    drawn from both sides, as SketchUp does, encloses nothing, and looks nowhere.

    Args:
        places: (n, 3).
        faces: (m, 3).
        least: the volume up to which a piece does not matter.
    """
    found = np.zeros(len(pieces.volumes), dtype=bool)
    corners = pieces.corners(places, faces)
    rounding = ROUNDING * np.linalg.norm(pieces.high - pieces.low, axis=1) ** 3
    for piece in np.flatnonzero(pieces.is_closed & (pieces.volumes < -np.maximum(least, rounding))):
        around = ~pieces.is_closed | (np.abs(pieces.volumes) > abs(pieces.volumes[piece]))
        around &= (pieces.low <= pieces.low[piece]).all(axis=1)
        around &= (pieces.high >= pieces.high[piece]).all(axis=1)
        found[piece] = not any(
            contains(places, faces[pieces.of_face == other], corners[piece])
            for other in np.flatnonzero(around)
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

"""How triangles hang together: vertices, edges and pieces."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from urdfkit.meshes.geometry import Flags, Floats, Integers

#: Vertices nearer than this are one, relative to the largest coordinate.
ROUNDING = 1e-6


def weld(vertices: Floats, faces: Integers) -> tuple[Floats, Integers]:
    """Vertices at the very same place become one; those that no triangle uses are left out."""
    used = np.zeros(len(vertices), dtype=bool)
    used[faces] = True
    places = vertices[used] + 0.0  # which makes -0.0 and 0.0 the same
    numbers = np.cumsum(used) - 1
    # Three columns are mixed to one number, by odd constants of 64 bits, which sorts fast.
    columns = np.ascontiguousarray(places, dtype=np.float64).view(np.uint64)
    with np.errstate(over="ignore"):
        key = columns[:, 0] * np.uint64(0x9E3779B97F4A7C15)
        key = (key ^ (key >> np.uint64(29))) + columns[:, 1] * np.uint64(0xBF58476D1CE4E5B9)
        key = (key ^ (key >> np.uint64(32))) + columns[:, 2] * np.uint64(0x94D049BB133111EB)
    _, first, inverse = np.unique(key, return_index=True, return_inverse=True)
    if not np.array_equal(places[first][inverse], places):  # two places gave one number
        _, first, inverse = np.unique(places, axis=0, return_index=True, return_inverse=True)
    return places[first], inverse.reshape(-1)[numbers[faces]]


def close_seams(places: Floats, faces: Integers) -> tuple[Floats, Integers]:
    """Vertices of open edges that only rounding keeps apart become one.

    Points nearer than half a cell share a cell of a grid, or of one that is shifted by half a cell
    along some axes.
    """
    edges = edge_counts(faces[three_cornered(faces)])
    loose = np.unique(edges.ends[edges.forward != edges.backward])
    if not len(loose):
        return places, faces
    cells = places[loose] / (2 * ROUNDING * (float(np.abs(places).max()) or 1.0))
    pairs = []
    for shift in np.ndindex(2, 2, 2):
        _, first, inverse = np.unique(
            np.floor(cells + np.array(shift) / 2), axis=0, return_index=True, return_inverse=True
        )
        pairs.append(np.stack([first[inverse.reshape(-1)], np.arange(len(loose))], axis=1))
    same = np.arange(len(places))
    same[loose] = loose[components(len(loose), np.concatenate(pairs))]
    return places, same[faces]


def three_cornered(faces: Integers) -> Flags:
    """The triangles whose corners are three different vertices."""
    a, b, c = faces.T
    found: Flags = (a != b) & (b != c) & (c != a)
    return found


class Edges(NamedTuple):
    """The edges of triangles.

    Attributes:
        ends: (e, 2), numbers of vertices, the smaller one first.
        forward, backward: (e,), how many triangles run along it in each direction.
    """

    ends: Integers
    forward: Integers
    backward: Integers

    @property
    def total(self) -> Integers:
        """(e,), how many triangles each has."""
        return self.forward + self.backward


def edge_counts(faces: Integers) -> Edges:
    """The edges of triangles, and how many triangles run along each."""
    directed = faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    low, high = directed.min(axis=1), directed.max(axis=1)
    number = int(high.max()) + 1 if len(high) else 1
    keys, inverse = np.unique(low * number + high, return_inverse=True)
    is_forward = directed[:, 0] == low
    total = np.bincount(inverse, minlength=len(keys))
    forward = np.bincount(inverse[is_forward], minlength=len(keys))
    ends = np.stack([keys // number, keys % number], axis=1)
    return Edges(ends, forward, total - forward)


def components(number: int, ends: Integers) -> Integers:
    """For each of some vertices the smallest vertex that edges connect it with.

    Labels sink along edges, and every label takes its label's label, so that long chains take
    few rounds.
    """
    label = np.arange(number)
    while True:
        before = label.copy()
        least = np.minimum(label[ends[:, 0]], label[ends[:, 1]])
        np.minimum.at(label, ends[:, 0], least)
        np.minimum.at(label, ends[:, 1], least)
        # The labels of the ends must sink too, or a chain is walked one vertex a round.
        np.minimum.at(label, before[ends[:, 0]], least)
        np.minimum.at(label, before[ends[:, 1]], least)
        label = label[label]
        if np.array_equal(label, before):
            return label


def duplicates(faces: Integers) -> int:
    """How many triangles have the same corners as an earlier one, in any order."""
    if not len(faces):
        return 0
    ordered = np.sort(faces, axis=1)
    number = int(ordered.max()) + 1
    _, pairs = np.unique(ordered[:, 0] * number + ordered[:, 1], return_inverse=True)
    return len(faces) - len(np.unique(pairs * number + ordered[:, 2]))


#: Part of the volume of all pieces below which one of them does not matter.
SIGNIFICANT = 0.01


class Pieces(NamedTuple):
    """The pieces of a mesh that hang together.

    Attributes:
        of_face: (m,), the number of the piece that each triangle belongs to.
        volumes: (p,), signed; without meaning for one that is not closed.
        flat: how many lie in a plane.
        inverted: how many look inwards.
    """

    of_face: Integers
    volumes: Floats
    flat: int
    inverted: int


def pieces(places: Floats, faces: Integers, flat: float) -> Pieces:
    """Take triangles apart into pieces that hang together by vertices.

    Args:
        places: (n, 3), welded.
        faces: (m, 3), each with three corners.
        flat: the thickness up to which a piece lies in a plane.
    """
    if not len(faces):
        return Pieces(np.zeros(0, dtype=np.int64), np.zeros(0), 0, 0)
    edges = edge_counts(faces)
    label = components(len(places), edges.ends)
    _, of_face = np.unique(label[faces[:, 0]], return_inverse=True)
    number = int(of_face.max()) + 1
    low, high = _extents(places, faces, of_face, number)
    a, b, c = (places[faces[:, corner]] - (low[of_face] + high[of_face]) / 2 for corner in range(3))
    volumes = np.bincount(of_face, np.einsum("ij,ij->i", a, np.cross(b, c)), number) / 6
    is_flat = _are_flat(places, faces, of_face, number, flat)
    # An edge belongs to the piece of its ends.
    _, of_edge = np.unique(label[edges.ends[:, 0]], return_inverse=True)
    ragged = np.bincount(of_edge, edges.forward != edges.backward, number) > 0
    closed = ~ragged & ~is_flat
    # A screw that looks inwards changes nothing.
    least = SIGNIFICANT * np.abs(volumes[closed]).sum()
    inwards = closed & (volumes < -least)
    inverted = _outermost(inwards, low, high, ragged | is_flat)
    return Pieces(of_face, volumes, int(is_flat.sum()), inverted)


def _extents(
    places: Floats, faces: Integers, of_face: Integers, number: int
) -> tuple[Floats, Floats]:
    """The bounding box of each piece."""
    low, high = np.full((number, 3), np.inf), np.full((number, 3), -np.inf)
    for corner in range(3):
        np.minimum.at(low, of_face, places[faces[:, corner]])
        np.maximum.at(high, of_face, places[faces[:, corner]])
    return low, high


def _are_flat(
    places: Floats, faces: Integers, of_face: Integers, number: int, thickness: float
) -> Flags:
    """Whether each piece lies in a plane: that of its largest triangle."""
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


def _outermost(inwards: Flags, low: Floats, high: Floats, others: Flags) -> int:
    """How many of the pieces that look inwards are no cavities of another one."""
    found = 0
    solid = ~others
    for piece in np.flatnonzero(inwards):
        around = solid & (low <= low[piece]).all(axis=1) & (high >= high[piece]).all(axis=1)
        around[piece] = False
        found += not around.any()
    return found

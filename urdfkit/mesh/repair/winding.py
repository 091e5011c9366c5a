"""Triangles made to agree on what is outside."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order

from urdfkit.mesh.components import contains, inside_out, take_apart
from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Flags, Integers, areas
from urdfkit.mesh.grouping import components
from urdfkit.mesh.repair.soup import TriangleSoup


def agree(soup: TriangleSoup) -> TriangleSoup:
    """Neighbours turned the same way; of each piece the smaller part of the area is turned."""
    if not len(soup.faces):
        return soup
    edges = Edges(soup.faces)
    if not edges.is_inconsistent.any():
        return soup
    pairs = edges.pairs
    pieces, is_turned = _senses(len(soup.faces), pairs, edges.is_inconsistent[edges.count == 2])
    area = areas(soup.points, soup.faces)
    turned, whole = np.bincount(pieces, area * is_turned), np.bincount(pieces, area)
    return soup.turned(is_turned ^ (turned > whole / 2)[pieces])


def _senses(number: int, pairs: Integers, twisted: Flags) -> tuple[Integers, Flags]:
    """The pieces of a surface, and which faces do not agree with the first one of their piece.

    Args:
        pairs: (k, 2), faces that share an edge.
        twisted: (k,), True for those that see it in the same direction.

    Returns:
        (m,), the number of the piece of each face; (m,), True for those to be turned.
    """
    _, first, pieces = np.unique(components(number, pairs), return_index=True, return_inverse=True)
    # From a node beyond all faces one of each piece is reached, and from there its neighbours.
    starts = np.column_stack([np.full(len(first), number), first])
    links = np.concatenate([pairs, starts])
    graph = coo_array((np.ones(len(links)), links.T), shape=(number + 1, number + 1))
    order, before = breadth_first_order(graph.tocsr(), number, directed=False)
    is_inconsistent = dict(zip(map(tuple, pairs.tolist()), twisted.tolist(), strict=True))
    is_turned = [False] * (number + 1)
    for face, origin in zip(order[1:].tolist(), before[order[1:]].tolist(), strict=True):
        bad = is_inconsistent.get((origin, face)) or is_inconsistent.get((face, origin), False)
        is_turned[face] = is_turned[origin] != bad
    return pieces, np.array(is_turned[:number])


def face_outwards(soup: TriangleSoup) -> TriangleSoup:
    """Closed bodies that are inside out turned over, with all that lies in them.

    A body inside another one may be a hole in it, and keeps its sense relative to the outer one.
    """
    if not len(soup.faces):
        return soup
    pieces = take_apart(soup.points, Edges(soup.faces))
    wrong = inside_out(soup.points, soup.faces, pieces)
    if not wrong.any():
        return soup
    corners = pieces.corners(soup.points, soup.faces)
    turn = wrong.copy()
    for outer in np.flatnonzero(wrong):
        within = ~wrong & (pieces.low[outer] <= corners).all(axis=1)
        within &= (corners <= pieces.high[outer]).all(axis=1)
        if within.any():
            shell = soup.faces[pieces.of_face == outer]
            for inner in np.flatnonzero(within):
                turn[inner] |= contains(soup.points, shell, corners[inner])
    return soup.turned(turn[pieces.of_face])

"""Consistent and outward orientation of triangles."""

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order

from urdfkit.mesh.components import contains, inside_out, split_pieces
from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Flags, Integers, areas
from urdfkit.mesh.grouping import components
from urdfkit.mesh.repair.soup import TriangleSoup


def orient_consistently(soup: TriangleSoup) -> TriangleSoup:
    """Orient adjacent faces consistently; flips the smaller part of the area of each piece."""
    edges = Edges(soup.faces)
    if not edges.is_inconsistent.any():
        return soup
    pairs = edges.pairs
    pieces, is_turned = _senses(len(soup.faces), pairs, edges.is_inconsistent[edges.count == 2])
    area = areas(soup.points, soup.faces)
    flipped, total = np.bincount(pieces, area * is_turned), np.bincount(pieces, area)
    return soup.flip(is_turned ^ (flipped > total / 2)[pieces])


def _senses(number: int, pairs: Integers, twisted: Flags) -> tuple[Integers, Flags]:
    """The pieces of a surface, and the faces oriented opposite to the first face of their piece.

    Args:
        pairs: (k, 2), faces that share an edge.
        twisted: (k,), True for pairs that traverse the edge in the same direction.

    Returns:
        (m,), number of the piece of each face; (m,), True for faces to flip.
    """
    _, first, pieces = np.unique(components(number, pairs), return_index=True, return_inverse=True)
    # An additional node leads to one face of each piece, and from there to its neighbours.
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
    """Flip closed bodies that are inside out, together with the bodies inside them.

    A body inside another may be a cavity, and keeps its orientation relative to the outer body.
    """
    pieces = split_pieces(soup.points, Edges(soup.faces))
    inverted = inside_out(soup.points, soup.faces, pieces)
    if not inverted.any():
        return soup
    corners = pieces.corners(soup.points, soup.faces)
    flipped = inverted.copy()
    for outer in np.flatnonzero(inverted):
        within = ~inverted & (pieces.low[outer] <= corners).all(axis=1)
        within &= (corners <= pieces.high[outer]).all(axis=1)
        if within.any():
            shell = soup.faces[pieces.of_face == outer]
            for inner in np.flatnonzero(within):
                flipped[inner] |= contains(soup.points, shell, corners[inner])
    return soup.flip(flipped[pieces.of_face])

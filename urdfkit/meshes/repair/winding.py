"""Triangles made to agree on what is outside."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import breadth_first_order, connected_components

from urdfkit.meshes.edges import Edges
from urdfkit.meshes.geometry import Flags, Floats, Integers, areas
from urdfkit.meshes.pieces import contains, inside_out, take_apart
from urdfkit.meshes.repair.soup import Soup


def agree(soup: Soup) -> Soup:
    """Neighbours turned the same way; of each piece the smaller part of the area is turned."""
    if not len(soup.faces):
        return soup
    edges = Edges(soup.faces)
    if not edges.is_twisted.any():
        return soup
    pairs = edges.pairs
    twisted = edges.is_twisted[edges.count == 2]
    number = len(soup.faces)
    graph = coo_array(
        (np.ones(2 * len(pairs)), (pairs.reshape(-1), pairs[:, ::-1].reshape(-1))),
        shape=(number, number),
    ).tocsr()
    _, pieces = connected_components(graph, directed=False)
    sign_of_pair = _lookup(pairs, twisted)
    area = areas(soup.points, soup.faces)
    turn = np.zeros(number, dtype=bool)
    for piece in np.unique(pieces[np.unique(pairs[twisted])]):
        members = np.flatnonzero(pieces == piece)
        signs = _signs(graph, int(members[0]), sign_of_pair, number)
        wrong = members[signs[members] < 0]
        if area[wrong].sum() > area[members].sum() / 2:
            wrong = members[signs[members] > 0]
        turn[wrong] = True
    return soup.turned(turn)


def _lookup(pairs: Integers, twisted: Flags) -> dict[tuple[int, int], bool]:
    return {
        (one, other): bad
        for (one, other), bad in zip(
            map(tuple, np.sort(pairs, axis=1).tolist()), twisted.tolist(), strict=True
        )
    }


def _signs(
    graph: coo_array, start: int, twisted: dict[tuple[int, int], bool], number: int
) -> Floats:
    """(m,), 1 or -1 for the faces that agree with the first one as they are, or turned."""
    order, before = breadth_first_order(graph, start, directed=False)
    signs = np.ones(number)
    for face in order[1:].tolist():
        origin = int(before[face])
        pair = (origin, face) if origin < face else (face, origin)
        signs[face] = -signs[origin] if twisted[pair] else signs[origin]
    return signs


def face_outwards(soup: Soup) -> Soup:
    """Closed bodies that are inside out turned over, with all that lies in them.

    A body inside another one may be a hole in it, and keeps its sense relative to the outer one.
    """
    if not len(soup.faces):
        return soup
    pieces = take_apart(soup.points, Edges(soup.faces))
    wrong = inside_out(soup.points, soup.faces, pieces)
    if not wrong.any():
        return soup
    turn = wrong[pieces.of_face]
    for outer in np.flatnonzero(wrong):
        shell = soup.faces[pieces.of_face == outer]
        for inner in np.flatnonzero(~wrong):
            inside = pieces.of_face == inner
            if contains(soup.points, shell, soup.points[soup.faces[inside][0, 0]]):
                turn |= inside
    return soup.turned(turn)

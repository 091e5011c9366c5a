"""Triangles that are no part of a surface: collapsed, repeated, fins, walls and scraps."""

import numpy as np

from urdfkit.mesh.components import take_apart
from urdfkit.mesh.edges import Edges, three_cornered
from urdfkit.mesh.geometry import Integers, areas
from urdfkit.mesh.grouping import components, distinct
from urdfkit.mesh.repair.soup import TriangleSoup

#: A scrap has fewer triangles than the smallest solid.
_SCRAP = 4
#: Or less than this part of all area, and is open.
_SMALL = 1e-4
#: Fins are taken off in rounds, for one may carry another.
_ROUNDS = 50


def drop_collapsed(soup: TriangleSoup) -> TriangleSoup:
    """Without triangles that have two corners in one point."""
    return soup.kept(three_cornered(soup.faces))


def drop_repeated(soup: TriangleSoup) -> TriangleSoup:
    """Each triangle once, whichever way round; two sides of a sheet are left as they are.

    Where the same triangle is there both ways, the one is kept that agrees with its neighbours.
    """
    if not len(soup.faces):
        return soup
    _, same, count = distinct(np.sort(soup.faces, axis=1))
    if (count[same] == 2).all() and _sides_cancel(soup, same):
        return soup
    if (count == 1).all():
        return soup
    single = soup.kept(count[same] == 1)
    agreeing = _directed_sides(single)
    order = np.array(
        [
            -sum((b, a) in agreeing for a, b in _sides(face)) if count[group] > 1 else 0
            for face, group in zip(soup.faces.tolist(), same.tolist(), strict=True)
        ]
    )
    ranked = np.lexsort((order, same))
    first = np.concatenate([[True], same[ranked][1:] != same[ranked][:-1]])
    keep = np.zeros(len(soup.faces), dtype=bool)
    keep[ranked[first]] = True
    return soup.kept(keep)


def drop_back_sides(soup: TriangleSoup) -> TriangleSoup:
    """One side of each sheet that has two, and encloses nothing."""
    if not len(soup.faces):
        return soup
    pieces = take_apart(soup.points, Edges(soup.faces))
    first, _, _ = distinct(np.sort(soup.faces, axis=1))
    keep = ~pieces.is_hollow[pieces.of_face]
    keep[first] = True
    return soup.kept(keep) if not keep.all() else soup


def _sides_cancel(soup: TriangleSoup, same: Integers) -> bool:
    """True if every triangle is there both ways round, as in a sheet with two sides."""
    a, b, c = soup.faces.T
    even = (a < b).astype(int) + (b < c) + (c < a) == 2
    turns = np.bincount(same, weights=np.where(even, 1.0, -1.0))
    return bool((turns == 0).all())


def _directed_sides(soup: TriangleSoup) -> set[tuple[int, int]]:
    return {side for face in soup.faces.tolist() for side in _sides(face)}


def _sides(face: list[int]) -> tuple[tuple[int, int], ...]:
    a, b, c = face
    return ((a, b), (b, c), (c, a))


def drop_fins(soup: TriangleSoup) -> TriangleSoup:
    """Without triangles that stick out of a non-manifold edge into the open."""
    for _ in range(_ROUNDS):
        if not len(soup.faces):
            break
        edges = Edges(soup.faces)
        count = edges.count[edges.of_face]
        fins = (count > 2).any(axis=1) & (count == 1).any(axis=1)
        if not fins.any():
            break
        soup = soup.kept(~fins)
    return soup


def drop_walls(soup: TriangleSoup) -> TriangleSoup:
    """Without sheets inside a body: pieces that end in non-manifold edges all around."""
    if not len(soup.faces):
        return soup
    edges = Edges(soup.faces)
    if not edges.is_non_manifold.any():
        return soup
    # Pieces that are connected without crossing a non-manifold edge.
    _, sheets = np.unique(components(len(edges.faces), edges.pairs), return_inverse=True)
    keep = np.ones(len(soup.faces), dtype=bool)
    for sheet in np.argsort(np.bincount(sheets)):
        inside = sheets == sheet
        # Every rim of the sheet is an edge that stays closed without it.
        uses = np.bincount(edges.of_face[inside].reshape(-1), minlength=len(edges.count))
        rest = np.bincount(edges.of_face[keep & ~inside].reshape(-1), minlength=len(edges.count))
        rims = uses == 1
        if rims.any() and (rest[rims] == 2).all() and not (uses + rest == 1)[uses > 0].any():
            keep &= ~inside
    return soup.kept(keep)


def drop_scraps(soup: TriangleSoup) -> TriangleSoup:
    """Without loose pieces of a few triangles that enclose nothing; one is always kept."""
    if not len(soup.faces):
        return soup
    edges = Edges(soup.faces)
    sizes = np.bincount(edges.bodies)
    area = np.bincount(edges.bodies, weights=areas(soup.points, soup.faces))
    is_open = np.zeros(len(sizes), dtype=bool)
    is_open[edges.bodies[(edges.count[edges.of_face] == 1).any(axis=1)]] = True
    scraps = is_open & ((sizes < _SCRAP) | (area < _SMALL * area.sum()))
    # Of a mesh that is nothing but loose triangles, none is a scrap of the rest.
    if area[scraps].sum() > 0.5 * area.sum():
        return soup
    return soup.kept(~scraps[edges.bodies])

"""Removal of collapsed and repeated triangles, fins, inner walls and scraps; welding of edges."""

import numpy as np
from scipy.spatial import cKDTree

from urdfkit.mesh.components import split_pieces
from urdfkit.mesh.edges import Edges, have_distinct_corners
from urdfkit.mesh.geometry import Integers, areas
from urdfkit.mesh.grouping import components, distinct
from urdfkit.mesh.repair.soup import TriangleSoup

#: A scrap is open and has fewer triangles than the smallest solid ...
_MIN_TRIANGLES = 4
#: ... or less than this part of the total area.
_SMALL_AREA_PART = 1e-4
#: Rounds of removing fins, as a fin may carry another one.
_ROUNDS = 50


def weld_open_edges(soup: TriangleSoup, tolerance: float) -> TriangleSoup:
    """Merge points of open edges within a tolerance; closed parts of the surface do not change."""
    edges = Edges(soup.faces)
    ends = np.unique(edges.ends[edges.is_open])
    pairs = cKDTree(soup.points[ends]).query_pairs(tolerance, output_type="ndarray")
    if not len(pairs):
        return soup
    return soup.merge(components(len(soup.points), ends[pairs]))


def drop_collapsed(soup: TriangleSoup) -> TriangleSoup:
    """Remove triangles with two corners at the same point."""
    return soup.select(have_distinct_corners(soup.faces))


def drop_repeated(soup: TriangleSoup) -> TriangleSoup:
    """Remove repeated triangles of any orientation, except from two-sided sheets.

    Of triangles with opposite orientation, the one that agrees with its neighbours is kept.
    """
    _, same, count = distinct(np.sort(soup.faces, axis=1))
    if (count[same] == 2).all() and _sides_cancel(soup, same):
        return soup
    if (count == 1).all():
        return soup
    single = soup.select(count[same] == 1)
    agreeing = {side for face in single.faces.tolist() for side in _sides(face)}
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
    return soup.select(keep)


def drop_back_sides(soup: TriangleSoup) -> TriangleSoup:
    """Remove one side of each two-sided sheet."""
    pieces = split_pieces(soup.points, Edges(soup.faces))
    first, _, _ = distinct(np.sort(soup.faces, axis=1))
    keep = ~pieces.is_hollow[pieces.of_face]
    keep[first] = True
    return soup.select(keep) if not keep.all() else soup


def _sides_cancel(soup: TriangleSoup, same: Integers) -> bool:
    """True if every triangle exists in both orientations, as in a two-sided sheet."""
    a, b, c = soup.faces.T
    even = (a < b).astype(int) + (b < c) + (c < a) == 2
    turns = np.bincount(same, weights=np.where(even, 1.0, -1.0))
    return bool((turns == 0).all())


def _sides(face: list[int]) -> tuple[tuple[int, int], ...]:
    a, b, c = face
    return ((a, b), (b, c), (c, a))


def drop_fins(soup: TriangleSoup) -> TriangleSoup:
    """Remove triangles between a non-manifold edge and an open edge."""
    for _ in range(_ROUNDS):
        edges = Edges(soup.faces)
        count = edges.count[edges.of_face]
        fins = (count > 2).any(axis=1) & (count == 1).any(axis=1)
        if not fins.any():
            break
        soup = soup.select(~fins)
    return soup


def drop_walls(soup: TriangleSoup) -> TriangleSoup:
    """Remove sheets inside a body: pieces bounded by non-manifold edges only."""
    edges = Edges(soup.faces)
    if not edges.is_non_manifold.any():
        return soup
    # Pieces that are connected without crossing a non-manifold edge.
    _, sheets = np.unique(components(len(edges.faces), edges.pairs), return_inverse=True)
    keep = np.ones(len(soup.faces), dtype=bool)
    for sheet in np.argsort(np.bincount(sheets)):
        inside = sheets == sheet
        # Every boundary edge of the sheet stays closed without it.
        uses = np.bincount(edges.of_face[inside].reshape(-1), minlength=len(edges.count))
        rest = np.bincount(edges.of_face[keep & ~inside].reshape(-1), minlength=len(edges.count))
        boundary = uses == 1
        if (
            boundary.any()
            and (rest[boundary] == 2).all()
            and not (uses + rest == 1)[uses > 0].any()
        ):
            keep &= ~inside
    return soup.select(keep)


def drop_scraps(soup: TriangleSoup) -> TriangleSoup:
    """Remove small open pieces, unless these are most of the mesh."""
    edges = Edges(soup.faces)
    sizes = np.bincount(edges.bodies)
    area = np.bincount(edges.bodies, weights=areas(soup.points, soup.faces))
    is_open = np.zeros(len(sizes), dtype=bool)
    is_open[edges.bodies[(edges.count[edges.of_face] == 1).any(axis=1)]] = True
    scraps = is_open & ((sizes < _MIN_TRIANGLES) | (area < _SMALL_AREA_PART * area.sum()))
    # A mesh of loose triangles only has no main surface.
    if area[scraps].sum() > 0.5 * area.sum():
        return soup
    return soup.select(~scraps[edges.bodies])

"""Spheres that cover a solid and stick out of it by little, for motion planners.

Candidates are the balls of the medial axis and random points inside, each with its depth below the
surface: a sphere about a candidate whose radius is its depth and a margin sticks out by no more
than the margin. A greedy set cover takes those that cover most points of the solid (P. M. Hubbard,
"Approximating polyhedra with spheres for time-critical collision detection", 1996; V. Chvatal, "A
greedy heuristic for the set-covering problem", 1979). Then the centres are moved, each to where it
needs the least margin for the points that are its own (S. P. Lloyd, "Least squares quantization in
PCM", 1982, with this measure of distance).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from urdfkit.core.record import Record
from urdfkit.mesh.distance import sample_surface
from urdfkit.mesh.geometry import Flags, Floats, Integers
from urdfkit.mesh.inside import are_inside, points_inside

#: Lines on which points inside are looked for, which are to be covered.
_COLUMNS = 1500
#: Candidates on the medial axis, and elsewhere inside.
_MEDIAL, _ELSEWHERE = 1200, 800
#: Points of the surface by which depths are known.
_SURFACE = 6000
#: A solid with fewer points inside is thin; of more than so many some are to be covered.
_FEW, _MANY = 200, 10_000
#: The margin is larger than one that does not do by less than this factor.
_CLOSE = 1.03
#: A ball that is entered by no more than this part of its radius is one of the medial axis.
_SAME = 0.999
#: Rounds in which centres move, directions tried in each, and what a step is of the last one.
_ROUNDS, _DIRECTIONS, _SHORTER = 30, 12, 0.92
#: Spheres that are exchanged for another one before it is certain that all of them are needed.
_SWAPS = 60
#: How far a center moves at once, as a part of its depth.
_INSIDE = 0.9
#: Of what may stay out, this part is covered, as other points show a little less.
_SPARE = 0.1
#: Less than any area of a triangle that counts.
_TINY = 1e-300
_SEED = 11


class Spheres(Record):
    """Spheres that cover a solid."""

    centers: Floats  # (n, 3)
    radii: Floats  # (n,)


class Covering:
    """The ways to cover a solid with spheres: with a larger margin, fewer of them.

    Args:
        triangles: (m, 3, 3), of closed surfaces, counter-clockwise from outside; they may overlap.
        coverage: the part of the points inside that spheres cover, from 0 to 1.
    """

    def __init__(self, triangles: Floats, coverage: float) -> None:
        surface, owner = sample_surface(triangles, _SURFACE)
        self._triangles, self._coverage = triangles, coverage
        self._tree = cKDTree(surface)
        # The centers fit their own points better than others, so the radii have points of theirs.
        points = self._sample(triangles, _COLUMNS, surface)
        self._points = np.random.default_rng(_SEED).permutation(points)[:_MANY]
        self._others = self._sample(triangles, 2 * _COLUMNS, surface[_MEDIAL:])
        normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), _TINY)
        size = float(np.ptp(surface, axis=0).max())
        self._step = size / 20
        medial = self._medial(surface[:_MEDIAL], normals[owner[:_MEDIAL]], size)
        medial = medial[are_inside(triangles, medial)]
        self._centers = np.concatenate(
            [medial, self._points[:: max(1, len(self._points) // _ELSEWHERE)]]
        )
        self._depths, _ = self._tree.query(self._centers)
        #: (k, n), by how much a candidate has to stick out to cover a point, as a part of the size.
        needed = cdist(self._points, self._centers) - self._depths
        self._sticks_out, self._size = (needed / size).astype(np.float16), size

    def _sample(self, triangles: Floats, columns: int, surface: Floats) -> Floats:
        """Points inside; of a thin part, which has few, also some of its surface."""
        inside, _ = points_inside(triangles, columns, _SEED + columns)
        return inside if len(inside) > _FEW else np.concatenate([inside, surface[:_MEDIAL]])

    def _medial(self, points: Floats, normals: Floats, size: float) -> Floats:
        """The centres of balls that touch the surface at points and elsewhere.

        Source: J. Ma, S. W. Bae, S. Choi, "3D medial axis point approximation using nearest
        neighbors and the normal field" (2012).
        """
        radii, shrinking = np.full(len(points), size), np.arange(len(points))
        for _ in range(_ROUNDS):
            at, normal, radius = points[shrinking], normals[shrinking], radii[shrinking]
            distances, nearest = self._tree.query(at - radius[:, None] * normal)
            away = at - self._tree.data[nearest]
            height = np.einsum("ij,ij->i", away, normal)
            smaller = (distances < _SAME * radius) & (height > 0)
            shrinking = shrinking[smaller]
            squares = np.einsum("ij,ij->i", away[smaller], away[smaller])
            radii[shrinking] = squares / (2 * height[smaller])
        found: Floats = points - radii[:, None] * normals
        return found

    def chosen(self, margin: float, most: int) -> list[int]:
        """The candidates that cover enough with a margin, by their numbers.

        Returns:
            Nothing if more than so many are needed.
        """
        covers = self._sticks_out <= margin / self._size
        chosen = _pruned(covers, _greedy(covers, self._coverage, 2 * most), self._coverage)
        return chosen if len(chosen) <= most else []

    def refined(self, chosen: list[int]) -> Spheres:
        """The chosen spheres, moved to where they stick out least."""
        random = np.random.default_rng(_SEED)
        centers, depths = self._centers[chosen], self._depths[chosen]
        least, best, step = np.inf, (centers, depths), self._step
        for _ in range(_ROUNDS):
            needed, owner = _needed(self._points, centers, depths)
            margin = float(np.quantile(needed, self._coverage))
            if margin < least:
                least, best = margin, (centers, depths)
            moved, moved_depths = centers.copy(), depths.copy()
            directions = random.normal(size=(_DIRECTIONS, 3))
            directions /= np.linalg.norm(directions, axis=1, keepdims=True)
            for number in range(len(centers)):
                own = self._points[(owner == number) & (needed <= margin)]
                if not len(own):
                    continue
                reach = min(step, _INSIDE * depths[number])
                tried = np.vstack([centers[number], centers[number] + reach * directions])
                below, _ = self._tree.query(tried)
                nearest = int((cdist(tried, own).max(axis=1) - below).argmin())
                moved[number], moved_depths[number] = tried[nearest], below[nearest]
            # Of a thin part the samples of the surface are farther than the surface.
            is_inside = are_inside(self._triangles, moved)
            centers = np.where(is_inside[:, None], moved, centers)
            depths = np.where(is_inside, moved_depths, depths)
            step *= _SHORTER
        return self._spheres(*best)

    def _spheres(self, centers: Floats, depths: Floats) -> Spheres:
        """Spheres just large enough for their own points; the farthest points stay uncovered."""
        needed, owner = _needed(self._others, centers, depths)
        counts = needed <= np.quantile(needed, self._coverage + _SPARE * (1 - self._coverage))
        radii = np.full(len(centers), -np.inf)
        np.maximum.at(radii, owner[counts], needed[counts])
        used = np.isfinite(radii)
        return Spheres(centers[used], (radii + depths)[used])


def _needed(points: Floats, centers: Floats, depths: Floats) -> tuple[Floats, Integers]:
    """How far spheres must stick out to cover each point, (n,), and which sphere needs least."""
    every = cdist(points, centers) - depths
    owner = every.argmin(axis=1)
    return every[np.arange(len(every)), owner], owner


def choose(coverings: Sequence[Covering], margin: float, most: int) -> list[list[int]]:
    """The candidates that cover each solid, with one margin for all, and at most ``most`` of them.

    Args:
        margin: the least; a larger one is taken where that needs more spheres.
        most: of all solids together, but at least one of each.
    """
    low = high = margin
    while not (found := _chosen(coverings, high, most)):
        low, high = high, 2 * high
    while high > _CLOSE * low:
        middle = (low * high) ** 0.5
        if fewer := _chosen(coverings, middle, most):
            found, high = fewer, middle
        else:
            low = middle
    return found


def _chosen(coverings: Sequence[Covering], margin: float, most: int) -> list[list[int]]:
    """The candidates of each solid that cover it with a margin; nothing if they are too many."""
    found: list[list[int]] = []
    for number, covering in enumerate(coverings, 1):
        left = most - sum(map(len, found)) - (len(coverings) - number)
        found.append(covering.chosen(margin, max(left, 1)))
        if not found[-1]:
            return []
    return found


def _greedy(covers: Flags, coverage: float, most: int) -> list[int]:
    """The columns of flags (k, n) that together have enough of the rows, the best one first.

    Returns:
        Nothing if more than so many are needed.
    """
    left = np.ones(len(covers), dtype=bool)
    gains = covers.sum(axis=0)
    chosen: list[int] = []
    while left.mean() > 1 - coverage:
        best = int(gains.argmax())
        if len(chosen) == most or not gains[best]:
            return []
        chosen.append(best)
        new = covers[:, best] & left
        left &= ~new
        gains -= covers[new].sum(axis=0)
    return chosen


def _pruned(covers: Flags, chosen: list[int], coverage: float) -> list[int]:
    """Fewer columns, if after one is removed some swaps with others make up for it."""
    allowed = (1 - coverage) * len(covers)
    best = chosen
    while len(best) > 1:
        chosen = list(best)
        times = covers[:, chosen].sum(axis=1)
        for _ in range(_SWAPS):
            alone = covers[:, chosen][times == 1].sum(axis=0)
            removed = chosen.pop(int(alone.argmin()))
            times -= covers[:, removed]
            if np.count_nonzero(times == 0) <= allowed:
                break
            gains = covers[times == 0].sum(axis=0)
            gains[removed] = 0
            added = int(gains.argmax())
            chosen.append(added)
            times += covers[:, added]
        else:
            return best
        best = chosen
    return best

"""Spheres that cover a solid and stick out of it by little, for motion planners.

Candidates are the balls of the medial axis and random points inside, each with its depth below the
surface: a sphere about a candidate whose radius is its depth and a margin sticks out by no more
than the margin. A greedy set cover takes those that cover most points of the solid (P. M. Hubbard,
"Approximating polyhedra with spheres for time-critical collision detection", 1996; V. Chvatal, "A
greedy heuristic for the set-covering problem", 1979). Then the centres are moved, one after the
other, to where they cover more of the points that the others leave out with a smaller margin.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import itemgetter

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from urdfkit.core.record import Record
from urdfkit.mesh.distance import sample_surface
from urdfkit.mesh.geometry import Flags, Floats, Integers
from urdfkit.mesh.inside import are_inside, points_inside

#: Lines on which points inside are looked for, which are to be covered.
_COLUMNS = 8000
#: Candidates on the medial axis, and elsewhere inside.
_MEDIAL, _ELSEWHERE = 1200, 800
#: Points of the surface by which depths are known; with fewer, centres move to where no point is
#: near, and their depths are too large.
_SURFACE = 20_000
#: A solid with fewer points inside is thin; candidates are chosen for so many, moved for so many.
_FEW, _ROUGH, _MANY = 200, 10_000, 24_000
#: This part of the points, those nearest to the surface, is to be covered, or more where more may
#: stay out by this factor: spheres that cover them leave no others out, and of all points too few
#: would be near the surface.
_SHALLOW, _OUTER = 1 / 3, 8
#: The margin is larger than one that does not do by less than this factor.
_CLOSE = 1.03
#: A ball that is entered by no more than this part of its radius is one of the medial axis.
_SAME = 0.999
#: Rounds in which a ball of the medial axis shrinks.
_SHRINKING = 30
#: Rounds in which centres move, directions tried in each, and what a step is of the last one.
_ROUNDS, _DIRECTIONS, _SHORTER = 80, 12, 0.965
#: The margin that centres move for, as a part of the least one so far; what is a near miss, as a
#: part of it; and how many near misses count as one in any case.
_CLOSER, _SOFT, _FAR = 0.98, 0.06, 3.0
#: A margin is taken for no less than this part of the size where it says what a near miss is.
_LEAST = 1e-3
#: Spheres that are exchanged for another one before it is certain that all of them are needed.
_SWAPS = 60
#: How far a center moves at once, as a part of its depth.
_INSIDE = 0.9
#: Of what may stay out, this part is covered, as other points show a little less.
_SPARE = 0.11
#: Less than any area of a triangle that counts.
_TINY = 1e-300
#: What lengths are counted in, as a part of the size; the largest of them; rows at a time.
_UNIT, _MOST, _ROWS = 2.0**-14, 2**15 - 1, 500
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
        share = min(1.0, max(_SHALLOW, _OUTER * (1 - coverage)))
        below, _ = self._tree.query(points)
        shallow = points[np.argsort(below)[: round(share * len(points))]]
        self._points = np.random.default_rng(_SEED).permutation(shallow)[:_MANY]
        #: So many of them may stay out.
        self._allowed = int((1 - coverage) / share * len(self._points))
        rough = self._points[:_ROUGH]
        self._roughly_allowed = int((1 - coverage) / share * len(rough))
        self._others = self._sample(triangles, _COLUMNS + 1, surface[_MEDIAL:])
        normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), _TINY)
        size = float(np.ptp(surface, axis=0).max())
        self._step = size / 20
        medial = self._medial(surface[:_MEDIAL], normals[owner[:_MEDIAL]], size)
        medial = medial[are_inside(triangles, medial)]
        self._centers = np.concatenate([medial, points[:: max(1, len(points) // _ELSEWHERE)]])
        self._depths, _ = self._tree.query(self._centers)
        self._size = size
        #: (k, n), by how much a candidate sticks out to cover a point, in `_UNIT` of the size.
        self._sticks_out = np.empty((len(rough), len(self._centers)), dtype=np.int16)
        for start in range(0, len(rough), _ROWS):
            needed = cdist(rough[start : start + _ROWS], self._centers) - self._depths
            self._sticks_out[start : start + _ROWS] = needed / (size * _UNIT)

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
        for _ in range(_SHRINKING):
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
        covers = self._covers(margin)
        chosen = _pruned(
            covers, _greedy(covers, self._roughly_allowed, 2 * most), self._roughly_allowed
        )
        return chosen if len(chosen) <= most else []

    def _covers(self, margin: float) -> Flags:
        """(k, n), which candidates cover a point with a margin."""
        covers: Flags = self._sticks_out <= int(min(margin / (self._size * _UNIT), _MOST))
        return covers

    def further(self, chosen: list[int], margin: float) -> int:
        """The candidate that covers most of what the chosen ones leave out with a margin."""
        covers = self._covers(margin)
        return int(covers[~covers[:, chosen].any(axis=1)].sum(axis=0).argmax())

    def refined(self, chosen: list[int]) -> tuple[Spheres, float]:
        """The chosen spheres, moved to where they cover enough with the least margin, and that one.

        A sphere moves to where fewer of the points that no other one covers stay out.
        """
        random = np.random.default_rng(_SEED)
        centers, depths = self._centers[chosen], self._depths[chosen]
        needed = cdist(centers, self._points) - depths[:, None]
        least, best, step = self._margin(needed), (centers, depths), self._step
        for _ in range(_ROUNDS):
            directions = random.normal(size=(_DIRECTIONS, 3))
            directions /= np.linalg.norm(directions, axis=1, keepdims=True)
            moved, moved_depths = centers.copy(), depths.copy()
            for number in range(len(centers)):
                reach = min(step, _INSIDE * depths[number])
                tried = np.vstack([centers[number], centers[number] + reach * directions])
                below, _ = self._tree.query(tried)
                nearest = self._best(needed, number, tried, below, _CLOSER * least, reach)
                if nearest:
                    moved[number], moved_depths[number] = tried[nearest], below[nearest]
                    at = tried[nearest : nearest + 1]
                    needed[number] = cdist(at, self._points)[0] - below[nearest]
            # Of a thin part the samples of the surface are farther than the surface.
            is_inside = are_inside(self._triangles, moved)
            left = np.flatnonzero(~is_inside)
            needed[left] = cdist(centers[left], self._points) - depths[left, None]
            centers = np.where(is_inside[:, None], moved, centers)
            depths = np.where(is_inside, moved_depths, depths)
            if (margin := self._margin(needed)) < least:
                least, best = margin, (centers, depths)
            step *= _SHORTER
        return self._spheres(*best), least

    def _margin(self, needed: Floats) -> float:
        """The least margin with which spheres cover enough, in m."""
        place = needed.shape[1] - 1 - self._allowed
        return float(np.partition(needed.min(axis=0), place)[place])

    def _best(
        self, needed: Floats, number: int, tried: Floats, below: Floats, margin: float, reach: float
    ) -> int:
        """Where a sphere leaves the fewest points out, by its number; near misses count in part."""
        soft = _SOFT * max(margin, _LEAST * self._size)
        near = np.flatnonzero(needed[number] < margin + 2 * reach + _FAR * soft)
        others = needed[:, near]
        others[number] = np.inf
        rest = others.min(axis=0)
        alone = rest > margin - _FAR * soft
        needs = cdist(tried, self._points[near[alone]]) - below[:, None]
        beyond = (np.minimum(needs, rest[alone]) - margin) / soft
        return int(np.tanh(beyond).sum(axis=1).argmin())

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


def fit(
    coverings: Sequence[Covering],
    margin: float,
    most: int,
    report: Callable[[int], None] = lambda done: None,
) -> list[Spheres]:
    """Spheres for each solid, with one margin for all, and at most ``most`` of them together.

    Args:
        margin: the least, in m; a larger one is taken where that needs more spheres.
        most: of all solids together, but at least one of each.
        report: called with the number of solids done.
    """
    if not coverings:
        return []
    chosen = _choose(coverings, margin, most)
    found = []
    for covering, candidates in zip(coverings, chosen, strict=True):
        found.append(covering.refined(candidates))
        report(len(found))
    for _ in range(most - sum(map(len, chosen))):  # spent where spheres stick out most
        worst = max(range(len(found)), key=lambda number: found[number][1])
        least = found[worst][1]
        if least <= margin:
            break
        chosen[worst].append(coverings[worst].further(chosen[worst], _CLOSER * least))
        found[worst] = min(found[worst], coverings[worst].refined(chosen[worst]), key=itemgetter(1))
    return [spheres for spheres, _ in found]


def _choose(coverings: Sequence[Covering], margin: float, most: int) -> list[list[int]]:
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


def _greedy(covers: Flags, allowed: int, most: int) -> list[int]:
    """The columns of flags (k, n) that together leave out no more rows than is allowed.

    Returns:
        Nothing if more than so many are needed.
    """
    left = np.ones(len(covers), dtype=bool)
    gains = covers.sum(axis=0)
    chosen: list[int] = []
    while np.count_nonzero(left) > allowed:
        best = int(gains.argmax())
        if len(chosen) == most or not gains[best]:
            return []
        chosen.append(best)
        new = covers[:, best] & left
        left &= ~new
        gains -= covers[new].sum(axis=0)
    return chosen


def _pruned(covers: Flags, chosen: list[int], allowed: int) -> list[int]:
    """Fewer columns, if after one is removed some swaps with others make up for it."""
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

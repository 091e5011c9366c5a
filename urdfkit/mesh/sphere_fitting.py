"""Spheres that cover a solid and hardly protrude from it, for motion planners.

Candidates are the balls of the medial axis and random points inside, each with its depth below the
surface: a sphere at a candidate whose radius is its depth plus a margin protrudes by at most the
margin. A greedy set cover selects those that cover most points of the solid (P. M. Hubbard,
"Approximating polyhedra with spheres for time-critical collision detection", 1996; V. Chvatal, "A
greedy heuristic for the set-covering problem", 1979). Then the centres are moved, one after the
other, to cover more of the otherwise uncovered points with a smaller margin.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from operator import itemgetter

import numpy as np
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from urdfkit.core.record import Record
from urdfkit.mesh.distance import sample_surface
from urdfkit.mesh.geometry import Flags, Floats, Integers, scaled_normals
from urdfkit.mesh.inside import are_inside, solid_points

#: Lines on which points inside are sampled, which are to be covered.
_COLUMNS = 8000
#: Candidates on the medial axis, and elsewhere inside.
_MEDIAL, _ELSEWHERE = 1200, 800
#: Points of the surface for computing depths; with fewer, centres move away from all of them, and
#: their depths become too large.
_SURFACE = 20_000
#: Numbers of points for choosing and moving candidates, and for choosing those of all solids: a
#: humanoid has 70, with one or two spheres for each.
_MAX_ROUGH, _MAX_POINTS, _MAX_ALL_ROUGH = 10_000, 24_000, 200_000
#: Part of the points to cover, those nearest to the surface, and its least ratio to the part that
#: may stay uncovered. Spheres that cover these points cover the others too, and too few of all
#: points are near the surface.
_SHALLOW, _OUTER = 1 / 3, 8
#: Number of points for estimating the depth of that part, and the factor that makes it sufficient.
_ESTIMATE, _BEYOND_ESTIMATE = 1000, 1.2
#: Ratio between a sufficient margin and an insufficient one at which the search ends.
_MAX_SEARCH_RATIO = 1.03
#: A ball of the medial axis contains surface points up to this distance, relative to its radius.
_TOUCHING = 0.999
#: Rounds in which a ball of the medial axis shrinks.
_SHRINK_ROUNDS = 30
#: Rounds in which centres move, directions in each round, and factor from one step to the next.
_ROUNDS, _DIRECTIONS, _STEP_FACTOR = 80, 12, 0.965
#: Target margin of a move, as a part of the least margin so far; width of the soft boundary, as a
#: part of the margin; and distance, in such widths, beyond which a point counts fully.
_TARGET_FACTOR, _SOFT, _FAR = 0.98, 0.06, 3.0
#: Least margin for the width of the soft boundary, as a part of the size.
_MIN_MARGIN = 1e-3
#: Swaps of spheres before all of them are considered necessary.
_MAX_SWAPS = 60
#: Greatest move of a center, as a part of its depth.
_MAX_MOVE = 0.9
#: Part of the uncovered points that is covered in reserve, as coverage is less at other points.
_RESERVE = 0.11
#: Points on each sphere, to measure how far it protrudes.
_ON_SPHERE = 100
#: Below the area of any triangle that matters.
_TINY = 1e-300
#: Unit of stored lengths, as a part of the size; their largest value; rows at a time.
_UNIT, _MAX_UNITS, _BLOCK = 2.0**-14, 2**15 - 1, 50
_SEED = 11


class Spheres(Record):
    """Spheres that cover a solid."""

    centers: Floats  # (n, 3)
    radii: Floats  # (n,)

    def distances(self, points: Floats) -> Floats:
        """(n,), distances of points from the nearest sphere; negative inside."""
        return np.asarray((cdist(points, self.centers) - self.radii).min(axis=1))

    def on_surfaces(self, random: np.random.Generator) -> Floats:
        """(k, n, 3), points spread evenly over each sphere."""
        directions = random.normal(size=(len(self.radii), _ON_SPHERE, 3))
        directions /= np.linalg.norm(directions, axis=2, keepdims=True)
        return np.asarray(self.centers[:, None] + self.radii[:, None, None] * directions)


class Covering:
    """Candidate spheres for covering a solid; with a larger margin, fewer are needed.

    Args:
        triangles: (m, 3, 3), of closed surfaces, counter-clockwise from outside; they may overlap.
        coverage: required part of the points inside that spheres cover, from 0 to 1.
        solids: number of solids that are covered together.
    """

    def __init__(self, triangles: Floats, coverage: float, solids: int = 1) -> None:
        surface, owner = sample_surface(triangles, _SURFACE)
        self._triangles, self._coverage = triangles, coverage
        self._tree = cKDTree(surface)
        # The centers fit their own points better than others, so the radii use separate points.
        points = solid_points(triangles, _COLUMNS, _SEED + _COLUMNS, surface[:_MEDIAL])
        share = min(1.0, max(_SHALLOW, _OUTER * (1 - coverage)))
        shallow = points[self._nearest_to_surface(points, share)]
        self._points = np.random.default_rng(_SEED).permutation(shallow)[:_MAX_POINTS]
        #: Number of points that may stay uncovered.
        self._allowed = int((1 - coverage) / share * len(self._points))
        rough = self._points[: min(_MAX_ROUGH, _MAX_ALL_ROUGH // solids)]
        self._roughly_allowed = int((1 - coverage) / share * len(rough))
        self._others = solid_points(
            triangles, _COLUMNS + 1, _SEED + _COLUMNS + 1, surface[_MEDIAL : 2 * _MEDIAL]
        )
        normals = scaled_normals(triangles)
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), _TINY)
        size = float(np.ptp(surface, axis=0).max())
        self._step = size / 20
        medial = self._medial(surface[:_MEDIAL], normals[owner[:_MEDIAL]], size)
        medial = medial[are_inside(triangles, medial)]
        self._centers = np.concatenate([medial, points[:: max(1, len(points) // _ELSEWHERE)]])
        self._depths, _ = self._tree.query(self._centers)
        self._size = size
        #: (k, n), protrusion of a candidate that covers a point, in `_UNIT` of the size.
        self._protrusions = np.empty((len(rough), len(self._centers)), dtype=np.int16)
        for start in range(0, len(rough), _BLOCK):
            needed = cdist(rough[start : start + _BLOCK], self._centers)
            needed -= self._depths
            needed /= size * _UNIT
            self._protrusions[start : start + _BLOCK] = needed

    def _nearest_to_surface(self, points: Floats, share: float) -> Integers:
        """Indices of a share of the points, those nearest to the surface, in ascending order.

        The nearest neighbour of a deep point takes longest to find, so that the depth at which the
        share ends is estimated first, and deeper points are not measured.
        """
        count = round(share * len(points))
        some, _ = self._tree.query(points[:: max(1, len(points) // _ESTIMATE)])
        bound = _BEYOND_ESTIMATE * float(np.quantile(some, share))
        depths, _ = self._tree.query(points, distance_upper_bound=bound)
        if np.count_nonzero(np.isfinite(depths)) < count:
            depths, _ = self._tree.query(points)
        return np.asarray(np.argsort(depths)[:count])

    def _medial(self, points: Floats, normals: Floats, size: float) -> Floats:
        """Centres of the balls that touch the surface at the points and at a second point.

        Source: J. Ma, S. W. Bae, S. Choi, "3D medial axis point approximation using nearest
        neighbors and the normal field" (2012).
        """
        radii, shrinking = np.full(len(points), size), np.arange(len(points))
        for _ in range(_SHRINK_ROUNDS):
            at, normal, radius = points[shrinking], normals[shrinking], radii[shrinking]
            distances, nearest = self._tree.query(at - radius[:, None] * normal)
            offsets = at - self._tree.data[nearest]
            height = np.einsum("ij,ij->i", offsets, normal)
            smaller = (distances < _TOUCHING * radius) & (height > 0)
            shrinking = shrinking[smaller]
            squares = np.einsum("ij,ij->i", offsets[smaller], offsets[smaller])
            radii[shrinking] = squares / (2 * height[smaller])
        return np.asarray(points - radii[:, None] * normals)

    def choose(self, margin: float, most: int) -> list[int]:
        """Indices of candidates that cover enough with a margin; empty if too many are needed."""
        covers = self._covers(margin)
        chosen = _pruned(
            covers, _greedy(covers, self._roughly_allowed, 2 * most), self._roughly_allowed
        )
        return chosen if len(chosen) <= most else []

    def _covers(self, margin: float) -> Flags:
        """(k, n), True if a candidate covers a point with a margin."""
        return np.asarray(self._protrusions <= int(min(margin / (self._size * _UNIT), _MAX_UNITS)))

    def next_candidate(self, chosen: list[int], margin: float) -> int:
        """The candidate that covers most of the points that the chosen candidates do not cover."""
        covers = self._covers(margin)
        return int(covers[~covers[:, chosen].any(axis=1)].sum(axis=0).argmax())

    def refined(self, chosen: list[int]) -> tuple[Spheres, float]:
        """The chosen spheres after optimisation of their positions, and their least margin.

        A sphere moves to cover more of the points that no other sphere covers.
        """
        random = np.random.default_rng(_SEED)
        centers, depths = self._centers[chosen], self._depths[chosen]
        protrusions = cdist(centers, self._points) - depths[:, None]
        least, best, step = self._margin(protrusions), (centers, depths), self._step
        for _ in range(_ROUNDS):
            directions = random.normal(size=(_DIRECTIONS, 3))
            directions /= np.linalg.norm(directions, axis=1, keepdims=True)
            moved, moved_depths = centers.copy(), depths.copy()
            target = _TARGET_FACTOR * least
            for number in range(len(centers)):
                reach = min(step, _MAX_MOVE * depths[number])
                candidates = np.vstack([centers[number], centers[number] + reach * directions])
                new_depths, _ = self._tree.query(candidates)
                choice = self._best(protrusions, number, candidates, new_depths, target, reach)
                if choice:
                    moved[number], moved_depths[number] = candidates[choice], new_depths[choice]
                    at = candidates[choice : choice + 1]
                    protrusions[number] = cdist(at, self._points)[0] - new_depths[choice]
            # At a thin part, the surface is nearer than its samples.
            is_inside = are_inside(self._triangles, moved)
            reset = np.flatnonzero(~is_inside)
            protrusions[reset] = cdist(centers[reset], self._points) - depths[reset, None]
            centers = np.where(is_inside[:, None], moved, centers)
            depths = np.where(is_inside, moved_depths, depths)
            if (margin := self._margin(protrusions)) < least:
                least, best = margin, (centers, depths)
            step *= _STEP_FACTOR
        return self._spheres(*best), least

    def _margin(self, protrusions: Floats) -> float:
        """Least margin with which spheres cover enough, in m."""
        place = protrusions.shape[1] - 1 - self._allowed
        return float(np.partition(protrusions.min(axis=0), place)[place])

    def _best(
        self,
        protrusions: Floats,
        number: int,
        candidates: Floats,
        new_depths: Floats,
        margin: float,
        reach: float,
    ) -> int:
        """Index of the position that leaves the fewest points uncovered; near misses count less."""
        soft = _SOFT * max(margin, _MIN_MARGIN * self._size)
        relevant = np.flatnonzero(protrusions[number] < margin + 2 * reach + _FAR * soft)
        others = protrusions[:, relevant]
        others[number] = np.inf
        rest = others.min(axis=0)
        alone = rest > margin - _FAR * soft
        own = cdist(candidates, self._points[relevant[alone]]) - new_depths[:, None]
        beyond = (np.minimum(own, rest[alone]) - margin) / soft
        return int(np.tanh(beyond).sum(axis=1).argmin())

    def _spheres(self, centers: Floats, depths: Floats) -> Spheres:
        """Spheres just large enough for their nearest points; the farthest stay uncovered."""
        protrusions, owner = _least_protrusions(self._others, centers, depths)
        part = self._coverage + _RESERVE * (1 - self._coverage)
        counts = protrusions <= np.quantile(protrusions, part)
        radii = np.full(len(centers), -np.inf)
        np.maximum.at(radii, owner[counts], protrusions[counts])
        used = np.isfinite(radii)
        return Spheres(centers[used], (radii + depths)[used])


def _least_protrusions(points: Floats, centers: Floats, depths: Floats) -> tuple[Floats, Integers]:
    """(n,), least protrusion of a sphere that covers each point, and the index of the sphere."""
    every = cdist(points, centers) - depths
    owner = every.argmin(axis=1)
    return every[np.arange(len(every)), owner], owner


def fit(
    coverings: Sequence[Covering],
    margin: float,
    most: int,
    report: Callable[[int], None] = lambda done: None,
) -> list[Spheres]:
    """Spheres for each solid, with a common margin and at most ``most`` spheres together.

    Args:
        margin: least margin in m; it is increased if more spheres would be needed.
        most: number for all solids together, but at least one for each.
        report: called with the number of finished solids.
    """
    if not coverings:
        return []
    chosen = _choose(coverings, margin, most)
    fits = []
    for covering, candidates in zip(coverings, chosen, strict=True):
        fits.append(covering.refined(candidates))
        report(len(fits))
    for _ in range(most - sum(map(len, chosen))):  # for the solid with the largest margin
        worst = max(range(len(fits)), key=lambda number: fits[number][1])
        least = fits[worst][1]
        if least <= margin:
            break
        chosen[worst].append(coverings[worst].next_candidate(chosen[worst], _TARGET_FACTOR * least))
        fits[worst] = min(fits[worst], coverings[worst].refined(chosen[worst]), key=itemgetter(1))
    return [spheres for spheres, _ in fits]


def _choose(coverings: Sequence[Covering], margin: float, most: int) -> list[list[int]]:
    """Candidates for each solid with the least sufficient margin; arguments as for `fit`."""
    low = high = margin
    while not (chosen := _choose_with_margin(coverings, high, most)):
        low, high = high, 2 * high
    while high > _MAX_SEARCH_RATIO * low:
        middle = (low * high) ** 0.5
        if smaller := _choose_with_margin(coverings, middle, most):
            chosen, high = smaller, middle
        else:
            low = middle
    return chosen


def _choose_with_margin(coverings: Sequence[Covering], margin: float, most: int) -> list[list[int]]:
    """Candidates of each solid that cover it with a margin; empty if there are too many."""
    chosen: list[list[int]] = []
    for number, covering in enumerate(coverings, 1):
        available = most - sum(map(len, chosen)) - (len(coverings) - number)
        chosen.append(covering.choose(margin, max(available, 1)))
        if not chosen[-1]:
            return []
    return chosen


def _greedy(covers: Flags, allowed: int, most: int) -> list[int]:
    """Columns of flags (k, n) that together cover all but ``allowed`` rows.

    Returns:
        Empty if more than ``most`` columns are needed.
    """
    uncovered = np.ones(len(covers), dtype=bool)
    gains = covers.sum(axis=0)
    chosen: list[int] = []
    while np.count_nonzero(uncovered) > allowed:
        best = int(gains.argmax())
        if len(chosen) == most or not gains[best]:
            return []
        chosen.append(best)
        new = covers[:, best] & uncovered
        uncovered &= ~new
        gains -= covers[new].sum(axis=0)
    return chosen


def _pruned(covers: Flags, chosen: list[int], allowed: int) -> list[int]:
    """Fewer columns, if swaps with other columns make up for a removed one."""
    best = chosen
    while len(best) > 1:
        chosen = list(best)
        times = covers[:, chosen].sum(axis=1)
        for _ in range(_MAX_SWAPS):
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

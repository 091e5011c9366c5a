"""Capsules that cover a solid, few of them, for motion planners and collision checkers.

A capsule is the smallest, by volume, that contains enough of its points: the ends of its axis are
found by the simplex search of J. A. Nelder and R. Mead (1965). Where one capsule protrudes too
far, its points are divided in two and each point belongs to the capsule that it is deepest in, as
in the algorithm of S. P. Lloyd ("Least squares quantization in PCM", 1982).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import sqrt

import numpy as np
from scipy.optimize import minimize
from scipy.spatial import cKDTree

from urdfkit.core.record import Record
from urdfkit.core.spatial import basis, vector
from urdfkit.mesh.distance import sample_surface
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.inside import are_inside, solid_points

#: Lines on which points inside are sampled, points of the surface that are added for a thin part,
#: and how many of these points capsules are fitted to.
_COLUMNS, _THIN, _MAX_POINTS = 2000, 1200, 3000
#: Points of the surface for computing protrusions, and points on each capsule.
_SURFACE, _ON_CAPSULE = 20_000, 400
#: Part of the uncovered points that is covered in reserve, as coverage is less at other points.
_RESERVE = 0.11
#: The part of the points' extent that the first axis spans, and the size of the first simplex.
_FIRST_LENGTH, _FIRST_STEP = 0.6, 0.1
#: Evaluations of a search: from principal axes, and from an earlier capsule. Precision of the
#: ends as a part of the size.
_EVALUATIONS, _FEWER_EVALUATIONS, _PRECISION = 600, 200, 1e-4
#: Rounds in which points choose their capsule; with fewer points, a capsule is dropped.
_ROUNDS, _MIN_POINTS = 4, 10
#: The part of the protrusion that may remain after one division, or after this number of them;
#: otherwise they are not worth it. Two capsules may be no better for a disc, and four are.
_WORTH, _LOOKAHEAD = 0.95, 2
#: Quantile of protrusions that is compared with the margin.
_QUANTILE = 0.95
_SEED = 13
#: Square of the length of an axis that is a point, as a divisor.
_TINY = 1e-300


class Capsules(Record):
    """Capsules that cover a solid."""

    segments: Floats  # (n, 2, 3), the ends of their axes
    radii: Floats  # (n,)

    def distances(self, points: Floats) -> Floats:
        """(n,), distances of points from the nearest capsule; negative inside."""
        return np.asarray(self.each_distance(points).min(axis=0))

    def each_distance(self, points: Floats) -> Floats:
        """(k, n), distances of points from each capsule; negative inside."""
        pairs = zip(self.segments, self.radii, strict=True)
        return np.array([_to_segment(points, segment) - radius for segment, radius in pairs])

    def on_surfaces(self, random: np.random.Generator) -> Floats:
        """(k, n, 3), points spread evenly over the surface of each capsule."""
        pairs = zip(self.segments, self.radii, strict=True)
        return np.array([_on_surface(*pair, random) for pair in pairs])


def _to_segment(points: Floats, segment: Floats) -> Floats:
    """(n,), distances of points from a segment (2, 3)."""
    along = segment[1] - segment[0]
    square = float(along @ along)
    offsets = points - segment[0]
    if square > 0:
        shares = np.clip(offsets @ along / square, 0.0, 1.0)
        offsets = offsets - shares[:, None] * along
    return np.asarray(np.sqrt(np.einsum("ij,ij->i", offsets, offsets)))


def _radius_by_ends(points: Floats, place: int) -> Callable[[Floats], float]:
    """The radius of a capsule by the ends of its axis (6,): the distance of one of the points.

    Thousands of axes are tried for each capsule, so this avoids arrays of vectors: squares of
    distances are sums of products that are computed once.

    Args:
        points: (n, 3).
        place: index of the point among all, sorted by distance.
    """
    center = points.mean(axis=0)
    centered = points - center
    squares = np.einsum("ij,ij->i", centered, centered)

    def radius(ends: Floats) -> float:
        begin, along = ends[:3] - center, ends[3:] - ends[:3]
        length = max(float(along @ along), _TINY)
        ahead = centered @ along - begin @ along
        shares = np.minimum(np.maximum(ahead / length, 0.0), 1.0)
        from_axis = squares - centered @ (2 * begin) + shares * (shares * length - 2 * ahead)
        from_axis.partition(place)
        return sqrt(max(float(from_axis[place] + begin @ begin), 0.0))

    return radius


def _on_surface(segment: Floats, radius: float, random: np.random.Generator) -> Floats:
    """Points on a capsule; of its ends, too, each height has the same area (Archimedes)."""
    along = segment[1] - segment[0]
    length = float(np.linalg.norm(along))
    rows = np.array(basis(vector(along / length)) if length else np.eye(3))
    height = random.uniform(-radius, length + radius, _ON_CAPSULE)
    beyond = height - np.clip(height, 0.0, length)
    ring = np.sqrt(np.maximum(radius**2 - beyond**2, 0.0))
    angle = random.uniform(0.0, 2 * np.pi, _ON_CAPSULE)
    offsets = np.column_stack([ring * np.cos(angle), ring * np.sin(angle), height])
    return np.asarray(segment[0] + offsets @ rows)


#: A capsule: its axis (2, 3) and its radius.
_Capsule = tuple[Floats, float]


class _Cover(Record):
    """The capsules of a solid, and how far they protrude."""

    capsules: Capsules
    worst: int  # index of the capsule that protrudes farthest
    protrusion: float  # 95th percentile for all of them, in m

    @property
    def number(self) -> int:
        return len(self.capsules.radii)


class _Solid:
    """A solid with its best cover so far; arguments as for `fit`."""

    def __init__(self, triangles: Floats, coverage: float) -> None:
        self._triangles = triangles
        self._part = coverage + _RESERVE * (1 - coverage)
        surface, _ = sample_surface(triangles, _SURFACE)
        self._tree = cKDTree(surface)
        points = solid_points(triangles, _COLUMNS, _SEED, surface[:_THIN])
        self._points = np.random.default_rng(_SEED).permutation(points)[:_MAX_POINTS]
        # Capsules fit their own points better than others, so the radii use separate points.
        self._others = solid_points(triangles, _COLUMNS, _SEED + 1, surface[_THIN : 2 * _THIN])
        self.best = self._last = self._cover([self._smallest(self._points)])
        self._failures = 0

    def needs_more(self, margin: float, available: int) -> bool:
        """True if the cover protrudes too far, and another division may help."""
        added = self._last.number + 1 - self.best.number
        return self.best.protrusion > margin and self._failures < _LOOKAHEAD and added <= available

    def divide(self) -> None:
        """Try one more capsule than in the last cover."""
        self._last = self._divided(self._last)
        if self._last.protrusion < _WORTH * self.best.protrusion:
            self.best, self._failures = self._last, 0
        else:
            self._failures += 1

    def _divided(self, cover: _Cover) -> _Cover:
        """The best cover with two capsules in place of the one that protrudes farthest."""
        kept = [*zip(cover.capsules.segments, cover.capsules.radii, strict=True)]
        del kept[cover.worst]
        owner = cover.capsules.each_distance(self._points).argmin(axis=0)
        covers = [
            self._cover(self._settled([*kept, *map(self._smallest, halves)]))
            for halves in _in_halves(self._points[owner == cover.worst])
        ]
        return min(covers, key=lambda cover: cover.protrusion, default=cover)

    def _settled(self, capsules: list[_Capsule]) -> list[_Capsule]:
        """Capsules that fit the points that are deepest in them."""
        for _ in range(_ROUNDS):
            owner = _joined(capsules).each_distance(self._points).argmin(axis=0)
            groups = [self._points[owner == number] for number in range(len(capsules))]
            capsules = [
                self._moved(points, segment, _FEWER_EVALUATIONS)
                for points, (segment, _) in zip(groups, capsules, strict=True)
                if len(points) >= _MIN_POINTS
            ]
        return capsules

    def _smallest(self, points: Floats) -> _Capsule:
        """The smallest capsule that contains enough points, from each of their principal axes."""
        center, axes = _principal_axes(points)
        halves = _FIRST_LENGTH * np.ptp(points @ axes.T, axis=0)[:, None] / 2 * axes
        starts = [np.array([center - half, center + half]) for half in halves]
        found = [self._moved(points, start, _EVALUATIONS) for start in starts]
        return min(found, key=lambda capsule: _volume(*capsule))

    def _moved(self, points: Floats, start: Floats, evaluations: int) -> _Capsule:
        """The smallest capsule near an axis that contains enough of the points."""
        size = float(np.ptp(points, axis=0).max())
        place = int(self._part * (len(points) - 1))
        radius = _radius_by_ends(points, place)

        def volume(ends: Floats) -> float:
            return float(_volume(ends.reshape(2, 3), radius(ends)) ** (1 / 3))

        first = start.ravel()
        found = minimize(
            volume,
            first,
            method="Nelder-Mead",
            options={
                "initial_simplex": np.vstack([first, first + _FIRST_STEP * size * np.eye(6)]),
                "maxfev": evaluations,
                "xatol": _PRECISION * size,
                "fatol": _PRECISION * size,
            },
        )
        return found.x.reshape(2, 3), radius(found.x)

    def _cover(self, capsules: list[_Capsule]) -> _Cover:
        """Capsules with radii that suffice for other points, and how far they protrude."""
        joined = _joined(capsules)
        missing = np.quantile(joined.distances(self._others), self._part)
        result = Capsules(joined.segments, np.maximum(joined.radii + missing, 0.0))
        points = result.on_surfaces(np.random.default_rng(_SEED))
        beyond, _ = self._tree.query(points)
        beyond[are_inside(self._triangles, points.reshape(-1, 3)).reshape(beyond.shape)] = np.nan
        each = [_percentile(row) for row in beyond]
        return _Cover(result, int(np.argmax(each)), _percentile(beyond))


def fit(
    solids: Sequence[Floats],
    *,
    coverage: float,
    margin: float,
    most: int,
    report: Callable[[int], None] = lambda done: None,
) -> list[Capsules]:
    """Capsules for each solid: one, and more where they protrude farther than a margin.

    Args:
        solids: triangles (m, 3, 3) of each, of closed surfaces, counter-clockwise from outside;
            they may overlap.
        coverage: required part of the points inside that capsules cover, from 0 to 1.
        margin: 95th percentile of protrusions in m above which a solid gets another capsule.
        most: number for all solids together, but at least one for each.
        report: called with the number of finished solids.
    """
    found: list[_Solid] = []
    for triangles in solids:
        found.append(_Solid(triangles, coverage))
        report(len(found))
    while True:
        available = most - sum(part.best.number for part in found)
        unfinished = [part for part in found if part.needs_more(margin, available)]
        if not unfinished:
            return [part.best.capsules for part in found]
        max(unfinished, key=lambda one: one.best.protrusion).divide()


def _joined(capsules: Sequence[_Capsule]) -> Capsules:
    return Capsules(np.array([one for one, _ in capsules]), np.array([one for _, one in capsules]))


def _volume(segment: Floats, radius: float) -> float:
    length = float(np.linalg.norm(segment[1] - segment[0]))
    return float(np.pi) * radius**2 * (length + 4 / 3 * radius)


def _principal_axes(points: Floats) -> tuple[Floats, Floats]:
    """The centre of points, and their principal axes in the rows of a matrix."""
    center = points.mean(axis=0)
    _, axes = np.linalg.eigh(np.cov(points.T))
    return center, axes.T


def _in_halves(points: Floats) -> Iterator[tuple[Floats, Floats]]:
    """Two halves of some points, for each of their principal axes."""
    center, axes = _principal_axes(points)
    for axis in axes:
        is_above = (points - center) @ axis > 0
        halves = points[is_above], points[~is_above]
        if min(map(len, halves)) >= _MIN_POINTS:
            yield halves


def _percentile(protrusions: Floats) -> float:
    """The 95th percentile of protrusions, of which those inside are NaN."""
    beyond = protrusions[np.isfinite(protrusions)]
    return float(np.quantile(beyond, _QUANTILE)) if len(beyond) else 0.0

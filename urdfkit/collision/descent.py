"""Two links brought as near to one another as they go: a rare collision is found so.

Steps of Newton's method on the distance as a function of the joints between the two, from several
configurations at once. These are the same whatever the samples are, so that two runs with different
seeds find the same collisions.
"""

from __future__ import annotations

from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from urdfkit.collision.bounds import apart
from urdfkit.collision.chain import along
from urdfkit.collision.examine import Examiner, Pair, relative
from urdfkit.collision.forms import TOUCH, Gauge
from urdfkit.meshes.geometry import Floats, Integers

#: Configurations to begin in, and how many are drawn for each; the nearest one is taken.
_STARTS, _DRAWN = 12, 128
#: Steps at most; most descents end sooner, where the links cannot come nearer.
_STEPS = 25
#: Pairs of bodies of two links that are looked at, those which may be nearest.
_BODIES = 16
#: How deep a step is meant to lead, in m.
_GOAL = 1e-3
#: By so much a joint is moved to see what becomes of the distance, in rad or m.
_MOVE = 1e-4
#: Squared slopes under this lead nowhere.
_LEVEL = 1e-8
#: A step takes no joint farther than this part of its range.
_STRIDE = 0.25
#: A step that leads away is shortened, down to this part of the whole one.
_SHORTEST = 1e-3

Flags = NDArray[np.bool_]


class Closest(NamedTuple):
    """Where two links are nearest.

    Attributes:
        distance: signed, in m.
        configuration: (dof,).
    """

    distance: float
    configuration: Floats


def closest(examiner: Examiner, pair: Pair) -> Closest:
    """The nearest that two links are found to come; any collision will do.

    Args:
        examiner: of the robot.
        pair: numbers of links, with a joint that moves between them.
    """
    columns = examiner.chain.between(*pair)
    lower, upper = (ends[columns] for ends in examiner.chain.limits)
    random = np.random.default_rng(pair).random((_STARTS * _DRAWN, len(columns)))
    drawn = lower + (upper - lower) * random
    bodies = [_Bodies(examiner, pair, *gauged) for gauged in examiner.gauges(pair)]
    bounds = [one.bounds(drawn) for one in bodies]
    found, at = inf, drawn[0]
    for number in sorted(range(len(bodies)), key=lambda number: bounds[number].min())[:_BODIES]:
        nearest = bounds[number].reshape(_STARTS, _DRAWN).argmin(axis=1)
        starts = drawn[nearest + _DRAWN * np.arange(_STARTS)]
        descent = _Descent(bodies[number], starts, lower, upper)
        descent.run()
        if descent.distance < found:
            found, at = descent.distance, descent.best
        if found < -TOUCH:
            break
    return Closest(found, examiner.chain.default_with(columns, at[None])[0])


class _Bodies:
    """Two bodies, and how far they are apart, by the positions of the joints between."""

    def __init__(
        self, examiner: Examiner, pair: Pair, first: int, second: int, gauge: Gauge
    ) -> None:
        self._chain, self._gauge = examiner.chain, gauge
        self._columns = examiner.chain.between(*pair)
        self._branches = examiner.chain.branches(*pair)
        self._frames = [examiner.form(body).solid.frame for body in (first, second)]

    def bounds(self, positions: Floats) -> Floats:
        """(n,): at positions (n, k) they are no nearer, in m."""
        a, b = self._gauge.first, self._gauge.second
        rotation, translation = self._relative(positions)
        offset = translation + rotation @ b.center - a.center
        return apart(a.half, b.half, a.radius + b.radius, rotation, offset, inf)

    def distances(self, positions: Floats, inside: Flags) -> Floats:
        """(n,), signed, in m: of the hulls, or where these overlap of the bodies themselves.

        Args:
            positions: (n, k), of the joints between.
            inside: (n,), where the bodies themselves count; set where the hulls overlap.
        """
        found = np.zeros(len(positions))
        for at, way in enumerate(zip(*self._relative(positions), strict=True)):
            found[at] = -inf if inside[at] else self._gauge.hulls(*way)
            if found[at] <= TOUCH and not self._gauge.is_exact:
                inside[at], found[at] = True, self._gauge.distance(*way, inf)
        return found

    def exact(self, position: Floats) -> float:
        """The signed distance of the bodies themselves, in m, at a position (k,)."""
        rotation, translation = self._relative(position[None])
        return self._gauge.distance(rotation[0], translation[0], inf)

    def _relative(self, positions: Floats) -> tuple[Floats, Floats]:
        rows = self._chain.default_with(self._columns, positions)
        ends = zip(self._branches, self._frames, strict=True)
        first, second = (along(branch, rows) @ frame for branch, frame in ends)
        return relative(first, second)


class _Descent:
    """Some positions that go down together, each on its own way.

    Attributes:
        distance: the least so far, signed, in m.
        best: (k,), where.
    """

    def __init__(self, bodies: _Bodies, starts: Floats, lower: Floats, upper: Floats) -> None:
        self._bodies, self._lower, self._upper = bodies, lower, upper
        self._at = starts
        self._inside = np.zeros(len(starts), dtype=bool)
        self._slope = np.zeros_like(starts)
        self._damping = np.ones(len(starts))
        self._far = bodies.distances(starts, self._inside)
        self.distance, self.best = inf, starts[0]

    def run(self) -> None:
        """Go down until they collide, or can come no nearer."""
        self._note(self._at, self._far)
        fresh = going = np.arange(len(self._at))
        for _ in range(_STEPS):
            if not len(going) or self.distance < -TOUCH:
                break
            self._look_around(fresh)
            going = going[(self._downhill(going) ** 2).sum(axis=1) > _LEVEL]
            fresh = self._step(going)
            going = going[self._damping[going] > _SHORTEST]
        if self.distance >= -TOUCH:
            self.distance = self._bodies.exact(self.best)

    def _note(self, positions: Floats, distances: Floats) -> None:
        nearest = int(np.argmin(distances))
        if distances[nearest] < self.distance:
            self.distance, self.best = float(distances[nearest]), positions[nearest].copy()

    def _look_around(self, those: Integers) -> None:
        """How the distances change with each joint, by moving one after another a little."""
        count = self._at.shape[1]
        move = np.minimum(_MOVE, (self._upper - self._lower) / 2)
        moves = np.where(self._at[those] + move <= self._upper, move, -move)
        around = self._at[those, None, :] + np.eye(count) * moves[:, None, :]
        inside = np.repeat(self._inside[those], count)
        far = self._measured(around.reshape(-1, count), inside).reshape(-1, count)
        change = far - self._far[those, None]
        self._slope[those] = np.divide(change, moves, np.zeros_like(change), where=moves != 0)

    def _downhill(self, those: Integers) -> Floats:
        """(n, k), the slopes without those that lead out of the limits."""
        at, slope = self._at[those], self._slope[those]
        is_out = ((at <= self._lower) & (slope > 0)) | ((at >= self._upper) & (slope < 0))
        return np.where(is_out, 0.0, slope)

    def _step(self, those: Integers) -> Integers:
        """Go to where the distance would be nothing if it were linear; who came nearer."""
        slope = self._downhill(those)
        length = (self._far[those] + _GOAL) / (slope**2).sum(axis=1) * self._damping[those]
        way = -slope * length[:, None]
        most = (np.abs(way) / np.maximum(self._upper - self._lower, _MOVE)).max(axis=1)
        way *= np.minimum(1.0, _STRIDE / np.maximum(most, _STRIDE))[:, None]
        there = np.clip(self._at[those] + way, self._lower, self._upper)
        inside = self._inside[those]
        far = self._measured(there, inside)
        # What enters a hull is measured otherwise from there on, and may seem farther off.
        nearer = (far < self._far[those]) | (inside & ~self._inside[those])
        gone = those[nearer]
        self._at[gone], self._far[gone] = there[nearer], far[nearer]
        self._inside[gone] = inside[nearer]
        self._damping[gone] = np.minimum(1.0, 2 * self._damping[gone])
        self._damping[those[~nearer]] /= 3
        return gone

    def _measured(self, positions: Floats, inside: Flags) -> Floats:
        far = self._bodies.distances(positions, inside)
        if len(far):
            self._note(positions, far)
        return far

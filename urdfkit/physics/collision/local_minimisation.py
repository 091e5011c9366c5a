"""Two links brought as near to one another as they go: a rare collision is found so.

Steps of Newton's method on the distance as a function of the joints between the two, from several
configurations at once. These are the same whatever the samples are, so that two runs with different
seeds find the same collisions.
"""

from collections.abc import Mapping
from math import inf
from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Flags, Floats, Integers
from urdfkit.physics.collision.batch_kinematics import slopes
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.collision_geometry import DistanceQuery
from urdfkit.physics.collision.pair_queries import CollisionModel, Pair, relative

#: Configurations to begin in, each the nearest one of its share of those that were drawn: for the
#: pair of bodies of two links that may be nearest, the next one, and so on; no more are looked at.
_STARTS = (24, 12, 8, 6, *[4] * 12)
#: Steps at most; most descents end sooner, where the links cannot come nearer.
_STEPS = 25
#: The penetration that a step aims at, in m.
_GOAL = 1e-3
#: Joints with a smaller range, in rad or m, are taken to have this one.
_LEAST_RANGE = 1e-4
#: A vector that is shorter was left by coal as it was.
_NO_DIRECTION = 1e-6
#: Squared slopes under this lead nowhere.
_LEVEL = 1e-8
#: A step takes no joint farther than this part of its range.
_STRIDE = 0.25
#: A step that leads away is shortened, down to this part of the whole one.
_SHORTEST = 1e-3


class ClosestPair(NamedTuple):
    """Where two links are nearest."""

    distance: float  # signed, in m
    configuration: Floats  # (dof,)


def closest(collision_model: CollisionModel, pair: Pair) -> ClosestPair:
    """The nearest that two links are found to come; any collision will do.

    Args:
        pair: numbers of links, with a joint that moves between them.
    """
    columns = collision_model.kinematics.between(*pair)
    lower, upper = (ends[columns] for ends in collision_model.kinematics.limits)
    drawn = collision_model.drawn[:, columns]
    bodies = [_Bodies(collision_model, pair, *query) for query in collision_model.queries(pair)]
    bounds = [one.bounds() for one in bodies]
    found, at = inf, drawn[0]
    nearest_first = sorted(range(len(bodies)), key=lambda number: bounds[number].min())
    for number, count in zip(nearest_first, _STARTS, strict=False):
        nearest = bounds[number].reshape(count, -1).argmin(axis=1)
        starts = drawn[nearest + len(drawn) // count * np.arange(count)]
        descent = _Descent(bodies[number], starts, lower, upper)
        descent.run()
        if descent.distance < found:
            found, at = descent.distance, descent.best
        if found < -TOUCH:
            break
    return ClosestPair(found, collision_model.kinematics.default_with(columns, at[None])[0])


class _Measured(NamedTuple):
    """What was measured at some positions (n, k) of the joints between two bodies."""

    distance: Floats  # (n,), signed, in m
    slope: Floats  # (n, k), how it changes with each joint, in m per rad or per m
    inside: Flags  # (n,), True where the hulls overlap, so that the bodies themselves were measured


class _Bodies:
    """Two bodies, and how far they are apart, by the positions of the joints between."""

    def __init__(
        self,
        collision_model: CollisionModel,
        pair: Pair,
        first: int,
        second: int,
        query: DistanceQuery,
    ) -> None:
        self._kinematics, self._pair, self._query = collision_model.kinematics, pair, query
        self._columns = self._kinematics.between(*pair)
        self._branches = self._kinematics.branches(*pair)
        self._links = {*pair, *(step.child for branch in self._branches for step in branch)}
        self._frames = [collision_model.geometry(body).arrays.frame for body in (first, second)]
        self._drawn = collision_model.drawn_frames

    def bounds(self) -> Floats:
        """(m,): in the configurations that were drawn they are no nearer, in m."""
        return self._query.bounds(*relative(*self._placed(self._drawn)), inf)

    def measured(self, positions: Floats, inside: Flags) -> _Measured:
        """Distances at positions (n, k): of the hulls, or of the bodies where the hulls overlap.

        Args:
            inside: (n,), where the hulls are known to overlap.
        """
        of_links = self._of_links(positions)
        first, second = self._placed(of_links)
        count, inside = len(positions), inside.copy()
        distance, lines = np.zeros(count), np.zeros((count, 3, 3))
        for at, there in enumerate(zip(*relative(first, second), strict=True)):
            distance[at] = -inf if inside[at] else self._query.hulls(*there)
            if distance[at] <= TOUCH and not self._query.is_exact:
                inside[at], distance[at] = True, self._query.distance(*there, inf)
            lines[at] = self._query.line
        points, along = _directed(distance, lines)
        rotation = first[:, :3, :3]
        along = (rotation @ along[:, :, None])[..., 0]
        points = (rotation @ points[:, :, None])[..., 0] + first[:, :3, 3]
        slope = slopes(self._branches, self._columns, of_links, points, along)
        return _Measured(distance, slope, inside)

    def exact(self, position: Floats) -> float:
        """The signed distance of the bodies themselves, in m, at a position (k,)."""
        rotation, translation = relative(*self._placed(self._of_links(position[None])))
        return self._query.distance(rotation[0], translation[0], inf)

    def _of_links(self, positions: Floats) -> dict[int, Floats]:
        """The frames (n, 4, 4) of the links on the branches to the two."""
        rows = self._kinematics.default_with(self._columns, positions)
        return self._kinematics.frames(rows, self._links)

    def _placed(self, of_links: Mapping[int, Floats]) -> list[Floats]:
        """The frames (n, 4, 4) of the two bodies."""
        ends = zip(self._pair, self._frames, strict=True)
        return [of_links[link] @ frame for link, frame in ends]


def _directed(distance: Floats, lines: Floats) -> tuple[Floats, Floats]:
    """Points between two bodies and unit vectors from one to the other, (n, 3) each.

    Triangles that touch have no direction, and get zeros.

    Args:
        distance: (n,), in m.
        lines: (n, 3, 3), of a query.
    """
    start, end, normal = lines.swapaxes(0, 1)
    normal = np.where(distance[:, None] > TOUCH, end - start, normal)
    length = np.sqrt(np.einsum("ni,ni->n", normal, normal))[:, None]
    known = np.isfinite(length) & (length > _NO_DIRECTION)
    return (start + end) / 2, np.divide(normal, length, np.zeros_like(normal), where=known)


class _Descent:
    """Some positions that go down together, each on its own way.

    Attributes:
        distance: the least so far, signed, in m.
        best: (k,), where.
    """

    def __init__(self, bodies: _Bodies, starts: Floats, lower: Floats, upper: Floats) -> None:
        self._bodies, self._lower, self._upper = bodies, lower, upper
        self._at = starts
        self._damping = np.ones(len(starts))
        self._here = bodies.measured(starts, np.zeros(len(starts), dtype=bool))
        self.distance, self.best = inf, starts[0]
        self._note(starts, self._here.distance)

    def run(self) -> None:
        """Go down until they collide, or can come no nearer."""
        going = np.arange(len(self._at))
        for _ in range(_STEPS):
            going = going[(self._downhill(going) ** 2).sum(axis=1) > _LEVEL]
            if not len(going) or self.distance < -TOUCH:
                break
            self._step(going)
            going = going[self._damping[going] > _SHORTEST]
        if self.distance >= -TOUCH:
            self.distance = self._bodies.exact(self.best)

    def _note(self, positions: Floats, distances: Floats) -> None:
        nearest = int(np.argmin(distances))
        if distances[nearest] < self.distance:
            self.distance, self.best = float(distances[nearest]), positions[nearest].copy()

    def _downhill(self, those: Integers) -> Floats:
        """(n, k), the slopes without those that lead out of the limits."""
        at, slope = self._at[those], self._here.slope[those]
        is_out = ((at <= self._lower) & (slope > 0)) | ((at >= self._upper) & (slope < 0))
        return np.where(is_out, 0.0, slope)

    def _step(self, those: Integers) -> None:
        """Go to where the distance would be nothing if it were linear, and stay if it is nearer."""
        here, slope = self._here, self._downhill(those)
        length = (here.distance[those] + _GOAL) / (slope**2).sum(axis=1) * self._damping[those]
        way = -slope * length[:, None]
        most = (np.abs(way) / np.maximum(self._upper - self._lower, _LEAST_RANGE)).max(axis=1)
        way *= np.minimum(1.0, _STRIDE / np.maximum(most, _STRIDE))[:, None]
        there = np.clip(self._at[those] + way, self._lower, self._upper)
        found = self._bodies.measured(there, here.inside[those])
        self._note(there, found.distance)
        # What enters a hull is measured otherwise from there on, and may seem farther off.
        nearer = (found.distance < here.distance[those]) | (found.inside & ~here.inside[those])
        gone = those[nearer]
        self._at[gone] = there[nearer]
        for of_all, of_those in zip(here, found, strict=True):
            of_all[gone] = of_those[nearer]
        self._damping[gone] = np.minimum(1.0, 2 * self._damping[gone])
        self._damping[those[~nearer]] /= 3

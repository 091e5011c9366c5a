"""Local minimisation of the distance of two links, which finds rare collisions.

Newton steps on the distance as a function of the joints between the links, from several
configurations at once. The starts do not depend on the samples, so that runs with different seeds
find the same collisions.
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

#: Number of starts for the pair of bodies that may be nearest, the second nearest, and so on; other
#: pairs of bodies are ignored. Each start is the nearest of its share of random configurations.
_STARTS = (24, 12, 8, 6, *[4] * 12)
#: Most steps; most descents end earlier in a minimum.
_STEPS = 25
#: Target penetration of a step, in m.
_GOAL = 1e-3
#: Least range of a joint, in rad or m.
_LEAST_RANGE = 1e-4
#: Length below which coal has not set a vector.
_NO_DIRECTION = 1e-6
#: Squared gradient below which a descent ends.
_FLAT_GRADIENT = 1e-8
#: Largest step of a joint, as a part of its range.
_MAX_STEP = 0.25
#: Damping factor below which a descent ends; steps that increase the distance are damped.
_MIN_DAMPING = 1e-3


class ClosestPair(NamedTuple):
    """The least distance of two links, and its configuration."""

    distance: float  # signed, in m
    configuration: Floats  # (dof,)


def closest(collision_model: CollisionModel, pair: Pair) -> ClosestPair:
    """Minimise the distance of two links; ends at the first collision.

    Args:
        pair: numbers of links with a movable joint between them.
    """
    columns = collision_model.kinematics.between(*pair)
    lower, upper = (ends[columns] for ends in collision_model.kinematics.limits)
    drawn = collision_model.random_rows[:, columns]
    bodies = [_Bodies(collision_model, pair, *query) for query in collision_model.queries(pair)]
    bounds = [pair_of_bodies.bounds() for pair_of_bodies in bodies]
    least, best = inf, drawn[0]
    nearest_first = sorted(range(len(bodies)), key=lambda number: bounds[number].min())
    for number, count in zip(nearest_first, _STARTS, strict=False):
        nearest = bounds[number].reshape(count, -1).argmin(axis=1)
        starts = drawn[nearest + len(drawn) // count * np.arange(count)]
        descent = _Descent(bodies[number], starts, lower, upper)
        descent.run()
        if descent.distance < least:
            least, best = descent.distance, descent.best
        if least < -TOUCH:
            break
    return ClosestPair(least, collision_model.kinematics.default_with(columns, best[None])[0])


class _Measured(NamedTuple):
    """Distances at positions (n, k) of the joints between two bodies."""

    distance: Floats  # (n,), signed, in m
    slope: Floats  # (n, k), derivative with respect to each joint, in m per rad or per m
    inside: Flags  # (n,), True if the hulls overlap, so that the bodies were measured instead


class _Bodies:
    """Two bodies, and their distance as a function of the joints between them."""

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
        self._drawn = collision_model.random_frames

    def bounds(self) -> Floats:
        """(m,), lower bounds of the distance in the random configurations, in m."""
        return self._query.bounds(*relative(*self._placed(self._drawn)), inf)

    def measured(self, positions: Floats, inside: Flags) -> _Measured:
        """Distances at positions (n, k): of the hulls, or of the bodies if the hulls overlap.

        Args:
            inside: (n,), True if the hulls are known to overlap.
        """
        of_links = self._of_links(positions)
        first, second = self._placed(of_links)
        count, inside = len(positions), inside.copy()
        distance, lines = np.zeros(count), np.zeros((count, 3, 3))
        for row, transform in enumerate(zip(*relative(first, second), strict=True)):
            distance[row] = -inf if inside[row] else self._query.hulls(*transform)
            if distance[row] <= TOUCH and not self._query.is_exact:
                inside[row], distance[row] = True, self._query.distance(*transform, inf)
            lines[row] = self._query.line
        points, along = _directed(distance, lines)
        rotation = first[:, :3, :3]
        along = (rotation @ along[:, :, None])[..., 0]
        points = (rotation @ points[:, :, None])[..., 0] + first[:, :3, 3]
        slope = slopes(self._branches, self._columns, of_links, points, along)
        return _Measured(distance, slope, inside)

    def exact(self, position: Floats) -> float:
        """The signed distance of the bodies, in m, at a position (k,)."""
        rotation, translation = relative(*self._placed(self._of_links(position[None])))
        return self._query.distance(rotation[0], translation[0], inf)

    def _of_links(self, positions: Floats) -> dict[int, Floats]:
        """The frames (n, 4, 4) of the links on the branches."""
        rows = self._kinematics.default_with(self._columns, positions)
        return self._kinematics.frames(rows, self._links)

    def _placed(self, of_links: Mapping[int, Floats]) -> list[Floats]:
        """The frames (n, 4, 4) of the two bodies."""
        ends = zip(self._pair, self._frames, strict=True)
        return [of_links[link] @ frame for link, frame in ends]


def _directed(distance: Floats, lines: Floats) -> tuple[Floats, Floats]:
    """Points between two bodies and unit vectors from the first to the second, (n, 3) each.

    Touching triangles have no direction: zeros.

    Args:
        distance: (n,), in m.
        lines: (n, 3, 3), of a query.
    """
    start, end, normal = lines.swapaxes(0, 1)
    normal = np.where(distance[:, None] > TOUCH, end - start, normal)
    length = np.sqrt(np.einsum("ni,ni->n", normal, normal))[:, None]
    is_valid = np.isfinite(length) & (length > _NO_DIRECTION)
    return (start + end) / 2, np.divide(normal, length, np.zeros_like(normal), where=is_valid)


class _Descent:
    """Simultaneous descents from several positions.

    Attributes:
        distance: least signed distance so far, in m.
        best: (k,), position of the least distance.
    """

    def __init__(self, bodies: _Bodies, starts: Floats, lower: Floats, upper: Floats) -> None:
        self._bodies, self._lower, self._upper = bodies, lower, upper
        self._at = starts
        self._damping = np.ones(len(starts))
        self._current = bodies.measured(starts, np.zeros(len(starts), dtype=bool))
        self.distance, self.best = inf, starts[0]
        self._note(starts, self._current.distance)

    def run(self) -> None:
        """Descend until the bodies collide or reach a minimum."""
        active = np.arange(len(self._at))
        for _ in range(_STEPS):
            active = active[(self._slope_within_limits(active) ** 2).sum(axis=1) > _FLAT_GRADIENT]
            if not len(active) or self.distance < -TOUCH:
                break
            self._step(active)
            active = active[self._damping[active] > _MIN_DAMPING]
        if self.distance >= -TOUCH:
            self.distance = self._bodies.exact(self.best)

    def _note(self, positions: Floats, distances: Floats) -> None:
        nearest = int(np.argmin(distances))
        if distances[nearest] < self.distance:
            self.distance, self.best = float(distances[nearest]), positions[nearest].copy()

    def _slope_within_limits(self, active: Integers) -> Floats:
        """(n, k), derivatives, except those that lead out of the limits."""
        at, slope = self._at[active], self._current.slope[active]
        is_out = ((at <= self._lower) & (slope > 0)) | ((at >= self._upper) & (slope < 0))
        return np.where(is_out, 0.0, slope)

    def _step(self, active: Integers) -> None:
        """A Newton step towards the target penetration, accepted if the distance decreases."""
        current, slope = self._current, self._slope_within_limits(active)
        length = (current.distance[active] + _GOAL) / (slope**2).sum(axis=1) * self._damping[active]
        step = -slope * length[:, None]
        most = (np.abs(step) / np.maximum(self._upper - self._lower, _LEAST_RANGE)).max(axis=1)
        step *= np.minimum(1.0, _MAX_STEP / np.maximum(most, _MAX_STEP))[:, None]
        target = np.clip(self._at[active] + step, self._lower, self._upper)
        result = self._bodies.measured(target, current.inside[active])
        self._note(target, result.distance)
        # After the hulls begin to overlap, the bodies are measured, and may seem more distant.
        enters = result.inside & ~current.inside[active]
        nearer = (result.distance < current.distance[active]) | enters
        accepted = active[nearer]
        self._at[accepted] = target[nearer]
        for stored, new in zip(current, result, strict=True):
            stored[accepted] = new[nearer]
        self._damping[accepted] = np.minimum(1.0, 2 * self._damping[accepted])
        self._damping[active[~nearer]] /= 3

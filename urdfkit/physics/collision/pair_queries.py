"""Collisions and distances of pairs of links in many configurations.

Bounding boxes decide most configurations at once; coal measures the rest: first convex hulls, then
triangles.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property
from math import inf
from typing import NamedTuple

import numpy as np

from urdfkit.core.grouping import by_key
from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import TreeArrays
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.collision_geometry import CollisionGeometry, DistanceQuery

#: Two links, by their numbers in the `TreeArrays`, in ascending order.
Pair = tuple[int, int]

#: Random configurations from which the starts of descents are selected.
_SAMPLES = 1536

#: Relative error of the reported least distance, which is never too small.
SLACK = 0.1


class PairSample(NamedTuple):
    """The result of some configurations for one pair."""

    hits: list[int]  # indices of the configurations in which the links collide
    #: Least signed distance so far, in m; the limit if none is less.
    distance: float
    row: int  # index of the configuration of this distance; -1 if it is an earlier one


class CollisionModel:
    """The collision geometries of a robot and the links that carry them."""

    def __init__(self, kinematics: TreeArrays, geometries: Iterable[CollisionGeometry]) -> None:
        self.kinematics = kinematics
        number = {name: index for index, name in enumerate(kinematics.links)}
        self._geometries = list(geometries)
        self._of_link = by_key(
            (number[geometry.arrays.link], index) for index, geometry in enumerate(self._geometries)
        )

    @cached_property
    def random_rows(self) -> Floats:
        """(m, dof), random configurations within the limits, the same for all pairs."""
        return self.kinematics.samples(_SAMPLES, 0, 0)

    @cached_property
    def random_frames(self) -> dict[int, Floats]:
        """The frames of the links with bodies in these, (m, 4, 4) each: 60 MB for 300 links."""
        return self.kinematics.frames(self.random_rows, self.links)

    @property
    def links(self) -> list[int]:
        """The numbers of the links that have bodies."""
        return sorted(self._of_link)

    def bodies(self, link: int) -> list[int]:
        """The numbers of the bodies of a link."""
        return self._of_link[link]

    def geometry(self, body: int) -> CollisionGeometry:
        return self._geometries[body]

    def query(self, pairs: Iterable[Pair], limit: float = inf, *, effort: float = inf) -> PairQuery:
        """A query for pairs; distances above the limit, in m, are not measured.

        Args:
            effort: triangles that are tested for each two bodies before the first collision; it
                takes a second for a million of gears that mesh.
        """
        return PairQuery(self, pairs, limit, effort)

    def queries(self, pair: Pair) -> list[tuple[int, int, DistanceQuery]]:
        """The distance queries for the bodies of two links, each with the numbers of the bodies."""
        return [
            (first, second, DistanceQuery(self._geometries[first], self._geometries[second]))
            for first in self._of_link[pair[0]]
            for second in self._of_link[pair[1]]
        ]

    def frames(self, configurations: Floats, links: Collection[int]) -> dict[int, Floats]:
        """The frames of the bodies of links, (n, 4, 4) each, by body number."""
        of_links = self.kinematics.frames(configurations, links)
        return {
            body: of_links[link] @ self._geometries[body].arrays.frame
            for link in links
            for body in self._of_link[link]
        }


class PairQuery:
    """Distances of pairs in successive sets of configurations."""

    def __init__(
        self, collision_model: CollisionModel, pairs: Iterable[Pair], limit: float, effort: float
    ) -> None:
        self._collision_model = collision_model
        self._searches = {
            pair: _Search(collision_model.queries(pair), limit, effort) for pair in pairs
        }

    def at(
        self, configurations: Floats, pairs: Sequence[Pair] | None = None, *, count: bool
    ) -> list[PairSample]:
        """The results for configurations (n, dof), for each pair.

        Args:
            pairs: a subset of the pairs; all if None.
            count: find all collisions, not only one.
        """
        selected = self._searches if pairs is None else pairs
        links = sorted({link for pair in selected for link in pair})
        frames = self._collision_model.frames(configurations, links)
        return [self._searches[pair].at(frames, count=count) for pair in selected]


class _Search:
    """The query for one pair of links, with the least distance so far."""

    def __init__(
        self, queries: list[tuple[int, int, DistanceQuery]], limit: float, effort: float
    ) -> None:
        self._queries = queries
        self._best = limit
        self._effort = effort

    @property
    def _sure(self) -> float:
        """The distance, in m, above which measuring is not needed."""
        return (1 - SLACK) * max(self._best, 0.0)

    def at(self, frames: dict[int, Floats], *, count: bool) -> PairSample:
        """Measure the bodies where bounds are not sufficient, the nearest first."""
        hits: set[int] = set()
        row = -1
        for first, second, query in self._queries:
            rotation, translation = relative(frames[first], frames[second])
            bound = query.bounds(rotation, translation, self._sure)
            near = np.flatnonzero(bound < self._sure)
            left = self._effort
            for sample in near[np.argsort(bound[near])].tolist():
                if bound[sample] >= self._sure or (hits and not count) or (left < 0 and not hits):
                    break
                distance = query.distance(rotation[sample], translation[sample], self._best)
                left -= query.triangles if distance == 0 else 0
                if distance < self._best:
                    self._best, row = distance, sample
                if distance < -TOUCH:
                    hits.add(sample)
        return PairSample(sorted(hits), self._best, row)


def relative(first: Floats, second: Floats) -> tuple[Floats, Floats]:
    """Rotation (n, 3, 3) and translation (n, 3) of the second frame in the first."""
    back = first[:, :3, :3].transpose(0, 2, 1)
    offset = second[:, :3, 3] - first[:, :3, 3]
    return back @ second[:, :3, :3], (back @ offset[:, :, None])[:, :, 0]

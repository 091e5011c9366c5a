"""Pairs of links in many configurations: who collides, who comes near.

Boxes around the bodies and distances measured nearby decide most configurations at once; coal
measures the rest: first convex hulls, then triangles.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from functools import cached_property
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.physics.collision.batch_kinematics import Chain
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.bounds import DistanceBound, apart, moved, poses
from urdfkit.physics.collision.collision_geometry import CollisionGeometry, DistanceQuery

#: Two links, by their numbers in the chain, the first one before the second.
Pair = tuple[int, int]

#: Configurations among which descents begin.
_DRAWN = 1536

#: The least distance that is reported is at most so much larger than the true one.
SLACK = 0.1


class PairSample(NamedTuple):
    """What some configurations show of one pair.

    Attributes:
        hits: configurations in which the two collide.
        distance: the least signed distance, in m; the limit that was given if none is less.
        row: the configuration of that distance; -1 if none is less than the limit.
    """

    hits: int
    distance: float
    row: int


class Examiner:
    """Measures the pairs of one robot.

    Args:
        chain: how it moves.
        forms: its bodies.
    """

    def __init__(self, chain: Chain, forms: Iterable[CollisionGeometry]) -> None:
        self.chain = chain
        number = {name: index for index, name in enumerate(chain.links)}
        self._forms = list(forms)
        self._of_link: dict[int, list[int]] = {}
        for index, one in enumerate(self._forms):
            self._of_link.setdefault(number[one.solid.link], []).append(index)

    @cached_property
    def drawn(self) -> Floats:
        """(m, dof), configurations all over the limits, the same for all pairs."""
        return self.chain.samples(_DRAWN, 0, 0)

    @cached_property
    def drawn_frames(self) -> dict[int, Floats]:
        """Where the links with bodies are in these, (m, 4, 4) each: 60 MB for 300 links."""
        return self.chain.frames(self.drawn, self.links)

    @property
    def links(self) -> list[int]:
        """The numbers of the links that have bodies."""
        return sorted(self._of_link)

    def bodies(self, link: int) -> list[int]:
        """The numbers of the bodies of a link."""
        return self._of_link[link]

    def form(self, body: int) -> CollisionGeometry:
        """A body by its number."""
        return self._forms[body]

    def look(self, pairs: Sequence[Pair], limits: Sequence[float] | None = None) -> PairQuery:
        """Begin to measure pairs; those farther apart than the limits, in m, are left out."""
        return PairQuery(self, pairs, [inf] * len(pairs) if limits is None else limits)

    def gauges(self, pair: Pair) -> list[tuple[int, int, DistanceQuery]]:
        """What measures the bodies of two links, each with the numbers of the bodies."""
        return [
            (first, second, DistanceQuery(self._forms[first], self._forms[second]))
            for first in self._of_link[pair[0]]
            for second in self._of_link[pair[1]]
        ]

    def frames(self, configurations: Floats, links: Collection[int]) -> dict[int, Floats]:
        """Where the bodies of some links are, (n, 4, 4) each, by their numbers."""
        of_links = self.chain.frames(configurations, links)
        return {
            body: of_links[link] @ self._forms[body].solid.frame
            for link in links
            for body in self._of_link[link]
        }


class PairQuery:
    """A look at some pairs, which goes from configurations to more of them."""

    def __init__(self, examiner: Examiner, pairs: Sequence[Pair], limits: Sequence[float]) -> None:
        self._examiner = examiner
        self._links = sorted({link for pair in pairs for link in pair})
        self._pairs = [
            _Watch(examiner.gauges(pair), limit) for pair, limit in zip(pairs, limits, strict=True)
        ]

    def at(self, configurations: Floats, *, count: bool) -> list[PairSample]:
        """What some configurations (n, dof) show, for each pair.

        Args:
            configurations: of the robot.
            count: count the collisions; else a pair is done with when it collides once.
        """
        alive = [watch for watch in self._pairs if count or watch.is_free]
        frames = self._examiner.frames(configurations, self._links) if alive else {}
        for watch in self._pairs:
            watch.begin()
            if count or watch.is_free:
                watch.at(frames, count=count)
        return [watch.seen for watch in self._pairs]

    def hits(self, configurations: Floats) -> list[list[int]]:
        """For each pair, in which of some configurations (n, dof) it collides."""
        self.at(configurations, count=True)
        return [sorted(watch.hit) for watch in self._pairs]


class _Watch:
    """One pair of links."""

    def __init__(self, gauges: list[tuple[int, int, DistanceQuery]], limit: float) -> None:
        self._gauges = [(*gauge, DistanceBound()) for gauge in gauges]
        self._best, self._row = limit, -1
        self.hit: set[int] = set()
        self.is_free = True

    @property
    def seen(self) -> PairSample:
        return PairSample(len(self.hit), self._best, self._row)

    def begin(self) -> None:
        """Turn to other configurations."""
        self.hit, self._row = set(), -1

    @property
    def _sure(self) -> float:
        """From this distance on, in m, nothing is new."""
        return (1 - SLACK) * max(self._best, 0.0)

    def at(self, frames: dict[int, Floats], *, count: bool) -> None:
        for first, second, gauge, cover in self._gauges:
            self._compare(gauge, cover, *relative(frames[first], frames[second]), count=count)
            if self.hit and not count:
                break
        self.is_free = self.is_free and not self.hit

    def _compare(
        self,
        gauge: DistanceQuery,
        cover: DistanceBound,
        rotation: Floats,
        translation: Floats,
        *,
        count: bool,
    ) -> None:
        """Measure two bodies where no bound decides, the nearest first."""
        a, b = gauge.first, gauge.second
        offset = translation + rotation @ b.center - a.center
        bound = apart(a.half, b.half, a.radius + b.radius, rotation, offset, self._sure)
        left = np.flatnonzero(bound < self._sure)
        some = poses(rotation[left], offset[left], b.radius)
        bound = np.maximum(bound[left], cover.bound(some))
        while len(left):
            nearest = int(np.argmin(bound))
            if bound[nearest] >= self._sure:
                return
            sample = int(left[nearest])
            distance = gauge.distance(rotation[sample], translation[sample], self._best)
            self._note(sample, distance)
            if distance < -TOUCH:
                if not count:
                    return
            else:
                bound = np.maximum(bound, distance - moved(some, some[nearest]))
                cover.add(some[nearest], distance)
            bound[nearest] = inf
            left, bound, some = _thinned(left, bound, some, bound < self._sure)

    def _note(self, sample: int, distance: float) -> None:
        if distance < self._best:
            self._best, self._row = distance, sample
        if distance < -TOUCH:
            self.hit.add(sample)


def _thinned(
    left: Integers, bound: Floats, some: Floats, keep: NDArray[np.bool_]
) -> tuple[Integers, Floats, Floats]:
    """The rows to keep, once they are few enough to be worth the copy."""
    if 2 * np.count_nonzero(keep) > len(left):
        return left, bound, some
    return left[keep], bound[keep], some[keep]


def relative(first: Floats, second: Floats) -> tuple[Floats, Floats]:
    """Rotation (n, 3, 3) and translation (n, 3) of one frame in another."""
    back = first[:, :3, :3].transpose(0, 2, 1)
    offset = second[:, :3, 3] - first[:, :3, 3]
    return back @ second[:, :3, :3], (back @ offset[:, :, None])[:, :, 0]

"""What the processes that sample are given, and what they answer."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from urdfkit.collision.examine import Examiner, Pair
from urdfkit.meshes.geometry import Floats

#: Configurations around the nearest one that are tried at a time, for each joint between.
_TRIES = 8
#: How often it is tried, by the number of joints between: many of them make many valleys.
_ATTEMPTS = (1, 1, 1, 1, 2, 4, 4)
#: How far from it, as a part of each joint's range, at first and at last.
_FAR, _NEAR = 0.25, 0.002


class Found(NamedTuple):
    """What a task shows of one pair.

    Attributes:
        hits: configurations in which the two collide, at least 1 if they do anywhere.
        distance: the least, in m; the limit if none is less.
        configuration: (dof,), of that distance; None if none is less than the limit.
    """

    hits: int
    distance: float
    configuration: Floats | None


class Task(Protocol):
    """Work for one process."""

    def run(self, examiner: Examiner) -> list[Found]:
        """What it shows of each of its pairs."""

    def parts(self) -> list[Task]:
        """The same work, one task for each pair."""


class Samples(NamedTuple):
    """Pairs to look at in some samples.

    Attributes:
        pairs: of numbers of links.
        limits: for each, the least distance so far, in m.
        blocks: number and size of each block of samples.
        seed: of the samples.
        counts: count collisions, or stop at the first one of a pair.
    """

    pairs: tuple[Pair, ...]
    limits: tuple[float, ...]
    blocks: tuple[tuple[int, int], ...]
    seed: int
    counts: bool

    def run(self, examiner: Examiner) -> list[Found]:
        """What they show of each pair."""
        blocks = (examiner.chain.samples(size, self.seed, at) for at, size in self.blocks)
        return _looked(examiner, self.pairs, self.limits, blocks, count=self.counts)

    def parts(self) -> list[Task]:
        """One task for each pair."""
        return [
            self._replace(pairs=(pair,), limits=(limit,))
            for pair, limit in zip(self.pairs, self.limits, strict=True)
        ]


class Pose(NamedTuple):
    """Pairs to look at in one configuration (dof,)."""

    pairs: tuple[Pair, ...]
    configuration: Floats

    def run(self, examiner: Examiner) -> list[Found]:
        """What it shows of each pair."""
        limits = [np.inf] * len(self.pairs)
        return _looked(examiner, self.pairs, limits, [self.configuration[None]], count=True)

    def parts(self) -> list[Task]:
        """One task for each pair."""
        return [self._replace(pairs=(pair,)) for pair in self.pairs]


class Approach(NamedTuple):
    """A pair to bring as close together as can be, from where it is close already.

    Attributes:
        pair: of numbers of links.
        start: (dof,), where it came nearest.
        distance: there, in m.
        seed: of the random tries.
    """

    pair: Pair
    start: Floats
    distance: float
    seed: int

    def run(self, examiner: Examiner) -> list[Found]:
        """The nearest that random steps lead to, in several attempts."""
        columns = examiner.chain.between(*self.pair)
        best = Found(0, self.distance, self.start)
        for attempt in range(_ATTEMPTS[min(len(columns), 6)]):
            found = self._attempt(examiner, columns, attempt)
            if found.hits or found.distance < best.distance:
                best = found
            if best.hits:
                break
        return [best]

    def _attempt(self, examiner: Examiner, columns: list[int], attempt: int) -> Found:
        """Random steps from where the pair is close; smaller ones where none leads on."""
        lower, upper = examiner.chain.limits
        random = np.random.default_rng([self.seed, *self.pair, attempt])
        best, distance, step = self.start, self.distance, _FAR
        while step > _NEAR:
            tries = np.tile(best, (_TRIES * len(columns), 1))
            width = step * (upper - lower)[columns]
            tries[:, columns] += random.normal(size=(len(tries), len(columns))) * width
            tries = np.clip(tries, lower, upper)
            (found,) = _looked(examiner, [self.pair], [distance], [tries], count=False)
            if found.hits:
                return found
            if found.configuration is None:
                step *= 0.6
            else:
                best, distance = found.configuration, found.distance
        return Found(0, distance, best)

    def parts(self) -> list[Task]:
        """Itself alone."""
        return [self]


def _looked(
    examiner: Examiner,
    pairs: Sequence[Pair],
    limits: Sequence[float],
    blocks: Iterable[Floats],
    *,
    count: bool,
) -> list[Found]:
    """What some blocks of configurations (n, dof) show of pairs."""
    look = examiner.look(pairs, limits)
    hits = [0] * len(pairs)
    distances = list(limits)
    nearest: list[Floats | None] = [None] * len(pairs)
    for rows in blocks:
        for index, seen in enumerate(look.at(rows, count=count)):
            hits[index] += seen.hits
            distances[index] = seen.distance
            if seen.row >= 0:
                nearest[index] = rows[seen.row]
    return [Found(*one) for one in zip(hits, distances, nearest, strict=True)]

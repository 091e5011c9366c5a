"""What the processes that sample are given, and what they answer."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple, Protocol

import numpy as np

from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.local_minimisation import closest
from urdfkit.physics.collision.pair_queries import Examiner, Pair


class PairFindings(NamedTuple):
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

    def run(self, examiner: Examiner) -> list[PairFindings]:
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

    def run(self, examiner: Examiner) -> list[PairFindings]:
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

    def run(self, examiner: Examiner) -> list[PairFindings]:
        """What it shows of each pair."""
        limits = [np.inf] * len(self.pairs)
        return _looked(examiner, self.pairs, limits, [self.configuration[None]], count=True)

    def parts(self) -> list[Task]:
        """One task for each pair."""
        return [self._replace(pairs=(pair,)) for pair in self.pairs]


class Minimise(NamedTuple):
    """Pairs to bring as near together as they go.

    Attributes:
        pairs: of numbers of links, with a joint that moves between the two.
        limits: for each, the least distance so far, in m.
    """

    pairs: tuple[Pair, ...]
    limits: tuple[float, ...]

    def run(self, examiner: Examiner) -> list[PairFindings]:
        """The nearest that each pair comes."""
        found = []
        for pair, limit in zip(self.pairs, self.limits, strict=True):
            distance, configuration = closest(examiner, pair)
            hits = int(distance < -TOUCH)
            nearer = distance < limit
            found.append(
                PairFindings(hits, distance, configuration)
                if nearer
                else PairFindings(hits, limit, None)
            )
        return found

    def parts(self) -> list[Task]:
        """One task for each pair."""
        return [
            self._replace(pairs=(pair,), limits=(limit,))
            for pair, limit in zip(self.pairs, self.limits, strict=True)
        ]


def _looked(
    examiner: Examiner,
    pairs: Sequence[Pair],
    limits: Sequence[float],
    blocks: Iterable[Floats],
    *,
    count: bool,
) -> list[PairFindings]:
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
    return [PairFindings(*one) for one in zip(hits, distances, nearest, strict=True)]

"""What a process finds out about some pairs of links, from the first configuration to the last."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import inf
from typing import NamedTuple

from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.local_minimisation import closest
from urdfkit.physics.collision.pair_queries import CollisionModel, Pair, PairQuery

#: Samples in which the collisions of all pairs are counted; later, only pairs that have none
#: are looked at.
COUNTED = 1000
#: More samples are given up when the last half of so many showed nothing new.
ENOUGH = 10_000

#: Frames of all links in a block of samples take about so many bytes.
_MEMORY = 64e6
_FRAME = 128
_BLOCK = 1000


@dataclass
class PairFindings:
    """What is known of a pair."""

    hits_at_start: bool = False  # True if the two collide where the robot begins
    hits: int = 0  # of the samples that are counted, those in which they collide
    hits_elsewhere: bool = False  # True if they collide in another configuration
    samples: int = 0  # that were looked at
    distance: float = inf  # the least, in m
    configuration: Floats | None = None  # (dof,), of that distance

    @property
    def is_free(self) -> bool:
        """True if they were never found to collide."""
        return not (self.hits_at_start or self.hits or self.hits_elsewhere)


class Task(NamedTuple):
    """Pairs to look at, one by one."""

    pairs: tuple[Pair, ...]  # of numbers of links
    moves: tuple[bool, ...]  # for each, whether joints move one against the other
    start: Floats  # (dof,), where the robot begins
    samples: int  # to look at
    seed: int  # of these

    def run(self, collision_model: CollisionModel) -> list[PairFindings]:
        """What is found out about each pair."""
        return _TaskRun(self, collision_model).findings()

    def parts(self) -> list[Task]:
        """The same work, one task for each pair."""
        pairs = zip(self.pairs, self.moves, strict=True)
        return [self._replace(pairs=(pair,), moves=(moves,)) for pair, moves in pairs]


class _TaskRun:
    """The run of one task: the start, samples to count in, descents, then ever more samples."""

    def __init__(self, task: Task, collision_model: CollisionModel) -> None:
        self._task, self._collision_model = task, collision_model
        self._query: PairQuery = collision_model.query(task.pairs)
        self._found = {pair: PairFindings() for pair in task.pairs}

    def findings(self) -> list[PairFindings]:
        task = self._task
        for pair, hits in self._measure(task.pairs, task.start[None], count=True):
            self._found[pair].hits_at_start = hits > 0
        moving = [pair for pair, moves in zip(task.pairs, task.moves, strict=True) if moves]
        counted = min(task.samples, COUNTED)
        if moving and counted:
            self._count(moving, counted)
            self._descend(moving)
            self._search(moving, counted)
        return list(self._found.values())

    def _count(self, pairs: Sequence[Pair], counted: int) -> None:
        for rows in self._blocks(0, counted):
            for pair, hits in self._measure(pairs, rows, count=True):
                self._found[pair].hits += hits
        for pair in pairs:
            self._found[pair].samples = counted

    def _descend(self, pairs: Sequence[Pair]) -> None:
        """Bring those together that were not found to collide: a rare collision is found so."""
        for pair in self._free(pairs):
            if self._collision_model.kinematics.between(*pair):
                found, nearest = self._found[pair], closest(self._collision_model, pair)
                found.hits_elsewhere = nearest.distance < -TOUCH
                if nearest.distance < found.distance:
                    found.distance, found.configuration = nearest

    def _search(self, pairs: Sequence[Pair], done: int) -> None:
        """Look for a first collision of the others, as long as there is hope."""
        free = self._free(pairs)
        while free and done < self._task.samples:
            before, end = free, min(self._task.samples, 2 * done)
            for rows in self._blocks(done, end):
                for pair, hits in self._measure(free, rows, count=False):
                    self._found[pair].hits_elsewhere = hits > 0
                free = self._free(free)
            done = end
            for pair in before:
                self._found[pair].samples = done
            if done >= ENOUGH and free == before:
                return

    def _measure(
        self, pairs: Sequence[Pair], rows: Floats, *, count: bool
    ) -> Iterator[tuple[Pair, int]]:
        """Count the configurations (n, dof) in which each pair collides."""
        for pair, seen in zip(pairs, self._query.at(rows, pairs, count=count), strict=True):
            found = self._found[pair]
            if seen.row >= 0 and seen.distance < found.distance:
                found.distance, found.configuration = seen.distance, rows[seen.row]
            yield pair, len(seen.hits)

    def _free(self, pairs: Sequence[Pair]) -> list[Pair]:
        return [pair for pair in pairs if self._found[pair].is_free]

    def _blocks(self, start: int, end: int) -> Iterator[Floats]:
        """The samples from one number to another in blocks that the memory can hold."""
        kinematics = self._collision_model.kinematics
        size = max(10, min(_BLOCK, int(_MEMORY / _FRAME / max(1, len(kinematics.links)))))
        for at in range(start, end, size):
            yield kinematics.samples(min(size, end - at), self._task.seed, at)

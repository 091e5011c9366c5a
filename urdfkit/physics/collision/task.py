"""A task of a worker process: the findings for a group of pairs of links."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import inf
from typing import NamedTuple

from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.local_minimisation import closest
from urdfkit.physics.collision.pair_queries import CollisionModel, Pair, PairQuery

#: Samples in which the collisions of all pairs are counted; in later samples, only pairs without
#: collisions are tested.
COUNTED_SAMPLES = 1000
#: Least number of samples; sampling then ends if the last half of the samples found nothing new.
MIN_SAMPLES = 10_000

#: Bytes for the frames of all links in a block of samples.
_MEMORY = 64e6
_FRAME_BYTES = 128
_BLOCK = 1000


@dataclass
class PairFindings:
    """Findings for a pair of links."""

    hits_at_start: bool = False  # True if the links collide in the initial configuration
    hits: int = 0  # number of collisions in the counted samples
    hits_elsewhere: bool = False  # True if they collide in another configuration
    samples: int = 0  # number of tested samples
    distance: float = inf  # least distance in m
    configuration: Floats | None = None  # (dof,), of the least distance

    @property
    def is_free(self) -> bool:
        """True if no collision was found."""
        return not (self.hits_at_start or self.hits or self.hits_elsewhere)


class Task(NamedTuple):
    """Pairs to test."""

    pairs: tuple[Pair, ...]  # of numbers of links
    moves: tuple[bool, ...]  # for each pair, whether joints move its links against each other
    start: Floats  # (dof,), the initial configuration
    samples: int  # number of samples
    seed: int  # of the samples

    def run(self, collision_model: CollisionModel) -> list[PairFindings]:
        """The findings for each pair."""
        return _TaskRun(self, collision_model).findings()

    def parts(self) -> list[Task]:
        """A separate task for each pair."""
        pairs = zip(self.pairs, self.moves, strict=True)
        return [self._replace(pairs=(pair,), moves=(moves,)) for pair, moves in pairs]


class _TaskRun:
    """One task: the initial configuration, counted samples, descents, then further samples."""

    def __init__(self, task: Task, collision_model: CollisionModel) -> None:
        self._task, self._collision_model = task, collision_model
        self._query: PairQuery = collision_model.query(task.pairs)
        self._found = {pair: PairFindings() for pair in task.pairs}

    def findings(self) -> list[PairFindings]:
        task = self._task
        for pair, hits in self._measure(task.pairs, task.start[None], count=True):
            self._found[pair].hits_at_start = hits > 0
        moving = [pair for pair, moves in zip(task.pairs, task.moves, strict=True) if moves]
        counted = min(task.samples, COUNTED_SAMPLES)
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
        """Minimise the distance of pairs without collisions, which finds rare collisions."""
        for pair in self._free(pairs):
            if self._collision_model.kinematics.between(*pair):
                found, nearest = self._found[pair], closest(self._collision_model, pair)
                found.hits_elsewhere = nearest.distance < -TOUCH
                if nearest.distance < found.distance:
                    found.distance, found.configuration = nearest

    def _search(self, pairs: Sequence[Pair], done: int) -> None:
        """Test pairs without collisions in further samples, as long as new collisions are found."""
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
            if done >= MIN_SAMPLES and free == before:
                return

    def _measure(
        self, pairs: Sequence[Pair], rows: Floats, *, count: bool
    ) -> Iterator[tuple[Pair, int]]:
        """Count the configurations (n, dof) in which each pair collides."""
        for pair, sample in zip(pairs, self._query.at(rows, pairs, count=count), strict=True):
            found = self._found[pair]
            if sample.row >= 0 and sample.distance < found.distance:
                found.distance, found.configuration = sample.distance, rows[sample.row]
            yield pair, len(sample.hits)

    def _free(self, pairs: Sequence[Pair]) -> list[Pair]:
        return [pair for pair in pairs if self._found[pair].is_free]

    def _blocks(self, start: int, end: int) -> Iterator[Floats]:
        """The samples of a range in blocks that fit into memory."""
        kinematics = self._collision_model.kinematics
        size = max(10, min(_BLOCK, int(_MEMORY / _FRAME_BYTES / max(1, len(kinematics.links)))))
        for at in range(start, end, size):
            yield kinematics.samples(min(size, end - at), self._task.seed, at)

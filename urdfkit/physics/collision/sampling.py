"""The pairs of a robot's links that can collide, found by sampling its configurations."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from math import inf
from typing import TYPE_CHECKING

from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import Chain, chain
from urdfkit.physics.collision.geometry_arrays import solids
from urdfkit.physics.collision.matrix import ClosestApproach, Matrix, PairResult, PairVerdict
from urdfkit.physics.collision.pair_queries import Pair
from urdfkit.physics.collision.task import Minimise, PairFindings, Pose, Samples, Task
from urdfkit.physics.collision.worker_pool import CollisionError, WorkerPool
from urdfkit.robot.adjacency import Adjacency

if TYPE_CHECKING:
    from urdfkit.ros import RosDescription

#: Samples in which the collisions of all pairs are counted; later, only pairs that have none
#: are looked at.
COUNTED = 1000
#: Pairs that collide in more of them always collide (as in MoveIt's Setup Assistant).
ALWAYS = 0.95
#: More samples are given up when the last half of so many showed nothing new.
ENOUGH = 10_000
#: More pairs, some 300 links with bodies, are rejected.
MAX_PAIRS = 50_000

#: Frames of all links in a block of samples take about so many bytes.
_MEMORY = 64e6
_FRAME = 128
_BLOCK = 1000

Progress = Callable[[int, int], None]


def collisions(
    robot: RosDescription,
    *,
    samples: int = 10_000,
    seed: int = 0,
    begin: Mapping[str, float] | None = None,
    units: bool | None = None,
    jobs: int | None = None,
    progress: Progress | None = None,
) -> Matrix:
    """Which links of a robot can collide with one another.

    >>> from urdfkit.lint.loading import read
    >>> found = collisions(read("models/good/two_link_arm/urdf/two_link_arm.urdf"), jobs=1)
    >>> for pair in found.pairs:
    ...     print(pair.first, pair.second, pair.verdict.value)
    base upper_arm adjacent
    base forearm never
    upper_arm forearm adjacent

    The same seed gives the same result, whatever the number of processes.

    Args:
        robot: from `urdfkit.lint.loading.read`.
        samples: configurations, equally likely everywhere within the joint limits.
        seed: of these.
        begin: positions of joints, in rad or m, where the robot begins; the others begin at 0,
            or in the middle if 0 is beyond their limits.
        units: apply the unit of length that a COLLADA file states, as RViz and Gazebo do; MoveIt
            and Pinocchio take the numbers as metres. As the robot's targets do if not given.
        jobs: processes; as many as there are processors, up to 8, if not given.
        progress: called with the number of samples done and of all.

    Raises:
        CollisionError: the robot has too many pairs of links with collision bodies, or no
            process can be started.
    """
    applies = robot.targets.applies_units if units is None else units
    bodies, omitted = solids(robot.model, robot.meshes, unit=applies)
    with WorkerPool(chain(robot.tree), bodies, jobs or _processors()) as crew:
        sampling = _Sampling(robot, crew, samples, seed, progress)
        sampling.run(begin or {})
    return Matrix(
        robot.model.name,
        tuple(sampling.results()),
        sampling.done,
        samples,
        min(samples, COUNTED),
        seed,
        (*omitted, *crew.omitted),
        sampling.parts(),
        _units(robot),
        applies,
    )


def _units(robot: RosDescription) -> dict[str, float]:
    """The meshes that state another unit than the metre, as they are named."""
    found: dict[str, float] = {}
    for link in robot.model.links:
        for body in link.collisions:
            if body.shape is None or body.shape.filename is None:
                continue
            mesh = robot.meshes.mesh(body.shape)
            if mesh is not None and mesh.unit != 1:
                found[body.shape.filename.value] = mesh.unit
    return found


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return min(len(os.sched_getaffinity(0)), 8)
    return min(os.cpu_count() or 1, 8)


@dataclass
class _State:
    """What is known of a pair so far."""

    verdict: PairVerdict | None = None
    hits: int = 0
    frequency: float | None = None
    distance: float = inf
    row: Floats | None = None


class _Sampling:
    """The rounds of one run: the default, samples to count in, then twice as many each time."""

    def __init__(
        self,
        robot: RosDescription,
        crew: WorkerPool,
        samples: int,
        seed: int,
        progress: Progress | None,
    ) -> None:
        self._pool = crew
        self._chain: Chain = chain(robot.tree)
        self._samples, self._seed, self._progress = samples, seed, progress
        self._adjacency = Adjacency(robot.tree)
        with_bodies = {solid.link for solid in crew.solids}
        self._links = [at for at, name in enumerate(self._chain.links) if name in with_bodies]
        pairs = sorted(islice(self._chain.pairs(self._links), MAX_PAIRS + 1))
        if len(pairs) > MAX_PAIRS:
            raise CollisionError(
                f"{len(self._links)} links with collision geometry are too many: they make more "
                f"than {MAX_PAIRS} pairs"
            )
        self._states = {pair: _State() for pair in pairs}
        self.done = self._reported = 0

    def run(self, begin: Mapping[str, float]) -> None:
        """All rounds."""
        for pair in self._states:
            if self._adjacency.is_adjacent(*self._names(pair)):
                self._states[pair].verdict = PairVerdict.ADJACENT
        self._begin(self._chain.row(begin))
        self._count()
        self._descend()
        self._search()
        for pair in self._free():
            self._states[pair].verdict = PairVerdict.NEVER

    def _begin(self, configuration: Floats) -> None:
        """Who collides where the robot begins; those that no joint moves are done with."""
        tasks = [Pose(tuple(group), configuration) for group in _groups(self._free())]
        self._run(tasks, _groups(self._free()))
        for pair in self._free():
            if self._states[pair].hits:
                self._states[pair].verdict = PairVerdict.DEFAULT
            elif self._adjacency.is_rigid(*self._names(pair)):
                self._states[pair].verdict = PairVerdict.NEVER

    def _count(self) -> None:
        """Count the collisions of all pairs that move."""
        moving = [pair for pair in self._states if self._moves(pair)]
        counted = min(self._samples, COUNTED)
        if not counted:
            return
        self._look(moving, counted, count=True)
        for pair in moving:
            frequency = self._states[pair].hits / counted
            self._states[pair].frequency = frequency
            if frequency and self._states[pair].verdict is None:
                always = frequency > ALWAYS
                self._states[pair].verdict = PairVerdict.ALWAYS if always else PairVerdict.SOMETIMES

    def _search(self) -> None:
        """Look for a first collision of the others, as long as there is hope."""
        while self.done < self._samples and (free := self._free()):
            self._look(free, min(self._samples, 2 * self.done), count=False)
            self._tell_hits(free)
            if self.done >= ENOUGH and self._free() == free:
                return

    def _descend(self) -> None:
        """Bring the others together: a rare collision is found so, whatever the seed."""
        free = [pair for pair in self._free() if self.done and self._chain.between(*pair)]
        groups = _groups(free)
        tasks = [Minimise(tuple(group), self._distances(group)) for group in groups]
        half = max(0, self._samples // 2 - self.done)  # it may last as long as half of the samples
        self._run(tasks, groups, half / max(1, len(tasks)))
        self._tell_hits(free)

    def _distances(self, pairs: Sequence[Pair]) -> tuple[float, ...]:
        return tuple(self._states[pair].distance for pair in pairs)

    def _tell_hits(self, pairs: Sequence[Pair]) -> None:
        for pair in pairs:
            if self._states[pair].verdict is None and self._states[pair].hits:
                self._states[pair].verdict = PairVerdict.SOMETIMES

    def _look(self, pairs: Sequence[Pair], end: int, *, count: bool) -> None:
        """Look at pairs in the samples from those that are done to a number."""
        blocks = self._blocks(self.done, end)
        tasks = [
            Samples(tuple(group), self._distances(group), blocks, self._seed, count)
            for group in _groups(pairs)
        ]
        share = (end - self.done) / max(1, len(tasks))
        self._run(tasks, _groups(pairs), share)
        self.done = end

    def _run(
        self, tasks: Sequence[Task], pairs: Sequence[Sequence[Pair]], share: float = 0.0
    ) -> None:
        """Do tasks; each is some samples' worth."""
        steps = iter(range(1, len(tasks) + 1))

        def advance() -> None:
            if self._progress and share:
                self._reported = max(self._reported, self.done + int(share * next(steps)))
                self._progress(self._reported, self._samples)

        for group, answer in zip(pairs, self._pool.run(tasks, advance), strict=True):
            for pair, found in zip(group, answer, strict=True):
                self._take(pair, found)

    def _take(self, pair: Pair, found: PairFindings | None) -> None:
        if found is None:
            self._states[pair].verdict = PairVerdict.UNKNOWN
            return
        state = self._states[pair]
        state.hits, state.distance = found.hits, found.distance
        if found.configuration is not None:
            state.row = found.configuration

    def _free(self) -> list[Pair]:
        """The pairs without a verdict."""
        return [pair for pair, state in self._states.items() if state.verdict is None]

    def _moves(self, pair: Pair) -> bool:
        """True if more samples can change the result of a pair."""
        verdict = self._states[pair].verdict
        rigid = self._adjacency.is_rigid(*self._names(pair))
        return not rigid and verdict in (None, PairVerdict.DEFAULT)

    def _names(self, pair: Pair) -> tuple[str, str]:
        return self._chain.links[pair[0]], self._chain.links[pair[1]]

    def _blocks(self, start: int, end: int) -> tuple[tuple[int, int], ...]:
        """The samples from one number to another in blocks that the memory can hold."""
        size = max(10, min(_BLOCK, int(_MEMORY / _FRAME / max(1, len(self._chain.links)))))
        return tuple((at, min(size, end - at)) for at in range(start, end, size))

    def parts(self) -> tuple[str, ...]:
        """The topmost links of the parts that are not compared; none if all are one part."""
        tops = dict.fromkeys(self._chain.parts[link] for link in self._links)
        return tuple(self._chain.links[top] for top in tops) if len(tops) > 1 else ()

    def results(self) -> Iterator[PairResult]:
        """What became of the pairs."""
        for pair, state in self._states.items():
            assert state.verdict is not None
            nearest = None
            if state.row is not None:
                nearest = ClosestApproach(state.distance, self._chain.pose(state.row, *pair))
            yield PairResult(
                *self._names(pair),
                state.verdict,
                not self._adjacency.is_rigid(*self._names(pair)),
                state.frequency,
                nearest,
            )


def _groups(pairs: Sequence[Pair]) -> list[Sequence[Pair]]:
    """The pairs in groups that are worth a task."""
    size = max(1, min(64, -(-len(pairs) // 8)))
    return [pairs[start : start + size] for start in range(0, len(pairs), size)]

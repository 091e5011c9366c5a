"""Computes the pairs of links that can collide by sampling configurations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import islice
from typing import TYPE_CHECKING

from urdfkit.core import limits
from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import TreeArrays, tree_arrays
from urdfkit.physics.collision.geometry_arrays import collision_arrays
from urdfkit.physics.collision.matrix import ClosestApproach, Matrix, PairResult, PairVerdict
from urdfkit.physics.collision.pair_queries import Pair
from urdfkit.physics.collision.task import COUNTED_SAMPLES, PairFindings, Task
from urdfkit.physics.collision.worker_pool import CollisionError, WorkerPool
from urdfkit.robot.adjacency import Adjacency

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.ros import RosDescription

#: Part of the samples above which a pair always collides (as in MoveIt's Setup Assistant).
ALWAYS = 0.95
#: Limit above which starting processes takes longer than they save.
MAX_PROCESSES = 8
#: Limit for pairs, about 300 links with bodies.
MAX_PAIRS = 50_000

#: Findings for adjacent links, which are not measured.
_ADJACENT = PairFindings()


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
    """Determine which links of a robot can collide with each other.

    >>> from urdfkit.lint.loading import read
    >>> found = collisions(read("models/good/two_link_arm/urdf/two_link_arm.urdf"), jobs=1)
    >>> for pair in found.pairs:
    ...     print(pair.first, pair.second, pair.verdict.value)
    base upper_arm adjacent
    base forearm never
    upper_arm forearm adjacent

    The same seed yields the same result for any number of processes.

    Args:
        robot: from `urdfkit.lint.loading.read`.
        samples: number of configurations, uniformly distributed within the joint limits.
        seed: of the samples.
        begin: initial positions of joints, in rad or m; the default is 0, or the middle of the
            range if 0 is outside of it.
        units: apply the unit of COLLADA files, as RViz and Gazebo do; MoveIt and Pinocchio read
            metres. By default, as the robot's targets do.
        jobs: number of processes; by default the number of processors, up to `MAX_PROCESSES`.
        progress: called with the number of finished samples and of all.

    Raises:
        CollisionError: the robot has too many pairs of links with collision bodies, or a process
            cannot be started.
    """
    applies = robot.targets.applies_units if units is None else units
    bodies, omitted = collision_arrays(robot.model, robot.meshes, unit=applies)
    moving, adjacency = tree_arrays(robot.tree), Adjacency(robot.tree)
    with WorkerPool(moving, bodies, jobs or min(limits.processors(), MAX_PROCESSES)) as pool:
        with_bodies = {body.link for body in pool.bodies}
        links = [at for at, name in enumerate(moving.links) if name in with_bodies]
        names = {p: (moving.links[p[0]], moving.links[p[1]]) for p in _pairs(moving, links)}
        moves = {pair: not adjacency.is_rigid(*both) for pair, both in names.items()}
        measured = {p: moves[p] for p, both in names.items() if not adjacency.is_adjacent(*both)}
        tasks = _tasks(measured, moving.row(begin or {}), samples, seed)
        findings = _measure_pairs(pool, tasks, samples, progress)
    counted = min(samples, COUNTED_SAMPLES)
    results = (
        _result(moving, pair, both, findings.get(pair, _ADJACENT), counted, moves=moves[pair])
        for pair, both in names.items()
    )
    return Matrix(
        robot.model.name,
        tuple(moving.links[link] for link in links),
        tuple(results),
        max((result.samples for result in findings.values() if result is not None), default=0),
        samples,
        counted,
        seed,
        (*omitted, *pool.omitted),
        _parts(moving, links),
        _units(robot),
        applies,
    )


def _units(robot: RosDescription) -> dict[str, float]:
    """Units in metres of the meshes with another unit than metres, by file name as written."""
    units: dict[str, float] = {}
    for link in robot.model.links:
        for body in link.collisions:
            if body.shape is None or body.shape.filename is None:
                continue
            mesh = robot.meshes.mesh(body.shape)
            if mesh is not None and mesh.unit != 1:
                units[body.shape.filename.value] = mesh.unit
    return units


def _measure_pairs(
    pool: WorkerPool, tasks: Sequence[Task], samples: int, progress: Progress | None
) -> dict[Pair, PairFindings | None]:
    """The findings for each pair; None for pairs that crash coal."""
    finished = iter(range(1, len(tasks) + 1))

    def advance() -> None:
        if progress:
            progress(samples * next(finished) // len(tasks), samples)

    answers = pool.run(tasks, advance)
    return {
        pair: findings
        for task, answer in zip(tasks, answers, strict=True)
        for pair, findings in zip(task.pairs, answer, strict=True)
    }


def _tasks(measured: Mapping[Pair, bool], start: Floats, samples: int, seed: int) -> list[Task]:
    """Tasks with groups of pairs; ``measured`` maps pairs to whether they move."""
    pairs = list(measured)
    size = max(1, min(64, -(-len(pairs) // 8)))
    groups = [tuple(pairs[at : at + size]) for at in range(0, len(pairs), size)]
    return [Task(g, tuple(measured[pair] for pair in g), start, samples, seed) for g in groups]


def _result(
    moving: TreeArrays,
    pair: Pair,
    names: tuple[str, str],
    findings: PairFindings | None,
    counted: int,
    *,
    moves: bool,
) -> PairResult:
    """The result for a pair; ``found`` is None if it crashes coal."""
    verdict, frequency, nearest = PairVerdict.UNKNOWN, None, None
    if findings is not None:
        verdict = _verdict(findings, counted, moves=moves)
        if findings.samples:
            frequency = findings.hits / counted
        if findings.configuration is not None:
            pose = moving.pose(findings.configuration, *pair)
            nearest = ClosestApproach(findings.distance, pose)
    return PairResult(*names, verdict, moves, frequency, nearest)


def _verdict(findings: PairFindings, counted: int, *, moves: bool) -> PairVerdict:
    if findings is _ADJACENT:
        return PairVerdict.ADJACENT
    if findings.hits_at_start:
        return PairVerdict.DEFAULT
    if not moves or findings.is_free:
        return PairVerdict.NEVER
    return PairVerdict.ALWAYS if findings.hits > ALWAYS * counted else PairVerdict.SOMETIMES


def _pairs(moving: TreeArrays, links: Sequence[int]) -> list[Pair]:
    """The pairs of links of the same part of the robot."""
    pairs = sorted(islice(moving.pairs(links), MAX_PAIRS + 1))
    if len(pairs) > MAX_PAIRS:
        raise CollisionError(
            f"{len(links)} links with collision geometry are too many: they form more "
            f"than {MAX_PAIRS} pairs"
        )
    return pairs


def _parts(moving: TreeArrays, links: Sequence[int]) -> tuple[str, ...]:
    """The topmost links of the parts; empty if there is only one part."""
    tops = dict.fromkeys(moving.parts[link] for link in links)
    return tuple(moving.links[top] for top in tops) if len(tops) > 1 else ()

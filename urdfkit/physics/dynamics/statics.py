"""What gravity asks of the joints of a robot that stands still, against what they can exert.

The poses looked at: all joints at zero; each joint at its limits, alone and all together; poses
sampled with a fixed seed; and for every joint climbs from its worst ones among these, one
coordinate at a time. The torque of a joint is a sine of the angle of any other one, and linear in
the way of a slide, so each step of the climb is a closed form. The root is held.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from urdfkit.core.record import Record
from urdfkit.physics.dynamics.robot import Dynamics, Floats
from urdfkit.robot.joint_loads import effort
from urdfkit.robot.joints import span
from urdfkit.robot.kinematics import SLIDING

#: Sampled poses, the seed of them, and rounds of a climb at most.
SAMPLES, SEED, ROUNDS = 1000, 0, 50

#: Climbs for each joint, from so many poses.
CLIMBS = 8

#: Torques that all climbs together may compute: a serial arm needs some thousands, and a chain of
#: a hundred joints is no robot that is worth minutes.
BUDGET = 200_000

#: Of a coordinate that is not looked at.
STILL = (0.0, 0.0)

#: A pose is told without what changes its torque by less than this part.
ASIDE = 1e-4


class Load(Record):
    """What gravity asks of one joint.

    Attributes:
        joint: its name.
        effort: what it can exert, in N m or N; None where the model does not say.
        at_zero: what it holds with all joints at zero; the sign is that of its axis.
        at_pose: what it holds at the pose that was asked for; that at zero if none was.
        worst: the largest that any pose asks of it, without sign: what effort would suffice.
        pose: in which it does, in rad or m; joints that hardly matter there are at rest, and
            those at 0, or on another branch of the tree, are left out.
    """

    joint: str
    effort: float | None
    at_zero: float
    at_pose: float
    worst: float
    pose: dict[str, float]

    @property
    def used(self) -> float | None:
        """The part of its effort that the worst pose takes."""
        return None if self.effort is None else self.worst / self.effort

    @property
    def is_exceeded(self) -> bool:
        """True if no controller can hold the worst pose."""
        return self.used is not None and self.used > 1


class Statics(Record):
    """The loads of all joints, the weakest first: those with the largest part of effort used.

    Attributes:
        loads: of the joints that can be set.
        poses: how many were looked at before the climbs.
        mass: of the robot with its payload, in kg.
        payload: masses in kg by link.
    """

    loads: tuple[Load, ...]
    poses: int
    mass: float
    payload: dict[str, float]

    @property
    def weakest(self) -> Load | None:
        """The joint that uses the largest part of its effort; None where none has one."""
        return next((load for load in self.loads if load.used is not None), None)


def statics(
    robot: Dynamics,
    pose: Mapping[str, float] | None = None,
    *,
    samples: int = SAMPLES,
    seed: int = SEED,
    joints: Iterable[str] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Statics:
    """The loads over the pose set.

    Args:
        robot: with its payload.
        pose: one that is looked at besides: positions of joints in rad or m.
        samples: how many poses are drawn between the limits.
        seed: of that drawing.
        joints: the names of those that are judged; all that can be set if None.
        progress: is told how many poses and joints are done, and of how many.
    """
    by_name = robot.tree.model.joints_by_name
    wanted = set(by_name if joints is None else joints)
    # A coordinate of a planar or floating joint has no name, and nothing drives it.
    columns = [
        (column, name)
        for column, name in enumerate(robot.columns)
        if name in by_name and name in wanted
    ]
    search = _Search(robot, BUDGET // max(1, CLIMBS * len(columns)))
    poses = np.array([*search.corners(), *search.drawn(samples, seed)])
    torques = np.zeros((len(poses), robot.nv))
    tell = progress or (lambda done, total: None)
    for number, x in enumerate(poses):
        torques[number] = robot.gravity_at(robot.expanded(x))
        if number % 1000 == 999:
            tell(number, len(poses) + len(columns))
    asked = robot.gravity(pose or {})
    found: list[Load] = []
    for column, name in columns:
        tell(len(poses) + len(found), len(poses) + len(columns))
        held = float(torques[0, column]), float(asked[column])
        worst, where = search.worst(column, poses, torques[:, column])
        found.append(Load(name, effort(by_name[name]), *held, worst, where))
    found.sort(key=lambda load: (-(load.used or 0.0), -load.worst))
    mass = robot.mass_properties().mass
    return Statics(tuple(found), len(poses), mass, dict(robot.payload))


class _Search:
    """Poses of a robot, and climbs among them.

    Args:
        robot: the robot.
        budget: torques that one climb may compute.
    """

    def __init__(self, robot: Dynamics, budget: int) -> None:
        self.robot = robot
        self.budget = budget
        self.computed = 0
        by_name = robot.tree.model.joints_by_name
        # A coordinate of a planar or floating joint has no name of its own, and stays at 0.
        ranges = [span(by_name[name]) if name in by_name else STILL for name in robot.columns]
        self.low = np.array([low for low, _ in ranges])
        self.high = np.array([high for _, high in ranges])
        self.rest = np.clip(np.zeros(robot.nv), self.low, self.high)
        slides = {name for name, joint in by_name.items() if joint.kind in SLIDING}
        self.slides = np.array([name in slides for name in robot.columns], dtype=bool)
        led = np.count_nonzero(robot.selection, axis=0) > 1
        self.is_led = led  # more than one joint moves with the coordinate
        self.others = _on_one_branch(robot) & (self.low < self.high)

    def corners(self) -> Iterator[Floats]:
        """Zero, or what is nearest to it; each joint at its ends; all at their ends."""
        yield np.zeros(self.robot.nv)
        yield self.rest
        yield self.low
        yield self.high
        for column in range(self.robot.nv):
            for end in (self.low, self.high):
                pose = self.rest.copy()
                pose[column] = end[column]
                yield pose

    def drawn(self, samples: int, seed: int) -> Floats:
        """Poses between the limits, (samples, nv)."""
        random = np.random.default_rng(seed)
        drawn: Floats = random.uniform(self.low, self.high, (samples, self.robot.nv))
        return drawn

    def worst(self, column: int, poses: Floats, torques: Floats) -> tuple[float, dict[str, float]]:
        """The largest torque of a coordinate, without sign, and the positions that matter to it.

        Args:
            column: the coordinate.
            poses: that were looked at, (n, nv).
            torques: of the coordinate in each of them, (n,).
        """
        starts = np.argsort(-np.abs(torques), kind="stable")[:CLIMBS]
        climbs = (self.climb(column, poses[start]) for start in starts)
        worst, x = max(climbs, key=lambda climb: climb[0])
        x = self.rested(column, x, worst)
        shape_mass = np.flatnonzero(self.others[column] & (x != 0))
        return worst, {self.robot.columns[other]: float(x[other]) for other in shape_mass}

    def climb(self, column: int, start: Floats) -> tuple[float, Floats]:
        """The largest torque of a coordinate near a pose, without sign, and where it is."""
        x = start.copy()
        self.computed = 0
        best = self._torque(x, column)
        sign = 1.0 if best >= 0 else -1.0
        for _ in range(ROUNDS):
            before = abs(best)
            for other in np.flatnonzero(self.others[column]).tolist():
                if self.computed <= self.budget:
                    best = self._improve(x, column, other, sign, best)
            if abs(best) <= before * (1 + 1e-12) or self.computed > self.budget:
                break
        return abs(best), x

    def rested(self, column: int, pose: Floats, worst: float) -> Floats:
        """A pose with every coordinate at rest that its torque does not depend on."""
        x: Floats = pose.copy()
        for other in range(self.robot.nv):
            kept, x[other] = x[other], self.rest[other]
            if abs(self._torque(x, column)) < (1 - ASIDE) * worst:
                x[other] = kept
        return x

    def _improve(self, x: Floats, column: int, other: int, sign: float, best: float) -> float:
        """Move one coordinate to where it makes the torque largest; keep it if it does."""
        kept = float(x[other])
        for candidate in self._candidates(x, column, other, sign):
            x[other] = candidate
            torque = self._torque(x, column)
            if sign * torque > sign * best:
                best, kept = torque, candidate
        x[other] = kept
        return best

    def _candidates(self, x: Floats, column: int, other: int, sign: float) -> list[float]:
        low, high = float(self.low[other]), float(self.high[other])
        if self.slides[other] and not self.is_led[other]:
            return [low, high]
        if self.is_led[other]:
            return [float(place) for place in np.linspace(low, high, 33)]
        return [low, high, *self._top(x, column, other, sign, low, high)]

    def _top(
        self, x: Floats, column: int, other: int, sign: float, low: float, high: float
    ) -> list[float]:
        """Where ``a + b cos q + c sin q`` is largest, from three of its values."""
        kept, values = float(x[other]), []
        for angle in (0.0, np.pi / 2, np.pi):
            x[other] = angle
            values.append(sign * self._torque(x, column))
        x[other] = kept
        middle = (values[0] + values[2]) / 2
        top = float(np.arctan2(values[1] - middle, values[0] - middle))
        return [angle for angle in (top - 2 * np.pi, top, top + 2 * np.pi) if low <= angle <= high]

    def _torque(self, x: Floats, column: int) -> float:
        self.computed += 1
        return float(self.robot.gravity_at(self.robot.expanded(x))[column])


def _on_one_branch(robot: Dynamics) -> NDArray[np.bool_]:
    """(nv, nv): which coordinates stand above or below one another, and may change its torque."""
    found: NDArray[np.bool_] = np.eye(robot.nv, dtype=bool)
    above = [np.zeros(robot.nv, dtype=bool)] * 2  # of the world and the free-flyer
    for own, parent in zip(
        list(robot.model.joints)[2:], list(robot.model.parents)[2:], strict=True
    ):
        moved_by = np.any(robot.selection[own.idx_v : own.idx_v + own.nv] != 0, axis=0)
        above.append(above[parent] | moved_by)
        found[moved_by] |= above[-1]
    found |= found.T
    return found

"""The gravity loads of joints, and the poses in which they are largest.

In the angle ``q`` of another joint, a torque is ``c + a cos q + b sin q``; in the position of a
prismatic joint, it is linear. So the best position of one joint, with the others fixed, is a closed
form. A sweep computes it for all joints above and below, one after another, in linear time.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from math import pi

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.core.spatial import ORIGIN, Z_AXIS, Vector, cross, dot, rotate, times
from urdfkit.physics.gravity_model import GravityModel, nearest_to_zero, rotated
from urdfkit.robot.joint_loads import GRAVITY
from urdfkit.robot.kinematics import best_angle

#: Most climbs (local searches) for each joint, and most sweeps of each climb.
MAX_CLIMBS, MAX_SWEEPS = 24, 30

#: Most steps of all climbs together: an arm needs some hundreds; a chain of a hundred joints is not
#: a real robot.
MAX_STEPS = 60_000

#: Most joints for which the worst pose is searched, in quadratic time; with more joints, the loads
#: at zero are returned.
MAX_SEARCHED = 300

#: Relative change of the torque by a joint that is at rest in a reported pose.
NEGLIGIBLE = 1e-4

#: Most joints of which those are moved to rest, in quadratic time.
MAX_RESTED = 50

#: Candidate positions of joints that others mimic, rounds, and factor of the range in each round.
_TRIALS, _ROUNDS, _RANGE_FACTOR = 17, 6, 0.25

#: Climbs that are refined with such candidates.
_MAX_REFINED = 3

#: Relative gain below which a search ends.
_MIN_GAIN = 1e-9


class Load(Record):
    """The gravity load of one joint."""

    joint: str
    effort: float | None  # effort limit, in N·m or N; None if the model defines none
    at_zero: float  # load with all joints at zero, with the sign of the axis
    at_pose: float  # load in the requested pose; by default, at zero
    worst: float  # largest absolute load of all poses: the sufficient effort
    #: The pose of the largest load, in rad or m; joints that hardly matter are at rest, and joints
    #: at 0 or on another branch of the tree are omitted.
    pose: dict[str, float]

    @property
    def used(self) -> float | None:
        """The part of the effort limit that the worst pose requires."""
        return None if self.effort is None else self.worst / self.effort

    @property
    def is_exceeded(self) -> bool:
        """True if no controller can hold the worst pose."""
        return self.used is not None and self.used > 1


class _Climb:
    """The search for the largest torque of one joint, from one pose.

    Args:
        start: positions of joints.
        budget: number of steps after which no sweep begins.
    """

    def __init__(
        self, model: GravityModel, name: str, start: Mapping[str, float], budget: int
    ) -> None:
        self._model = model
        self._bodies = model.bodies
        self._targets = model.moved[name]
        self._positions = model.positions(start)
        self._pose = dict(start)
        self._paths = {target: self._path(target) for target in self._targets}
        self._names = dict.fromkeys(
            model.bodies[number].law.leader
            for target in self._targets
            for number in (*self._paths[target], *model.below(target))
        )
        self._names.pop("", None)
        self.steps = 0  # number of visited bodies
        self._budget = budget
        value = self._value()
        self._sign = 1.0 if value >= 0 else -1.0
        self.torque = abs(value)  # largest torque so far, divided by g
        if len(self._targets) == 1:
            self._climb()

    def refine(self) -> None:
        """Try positions of the joints that others mimic, or of all if others mimic this one."""
        several = len(self._targets) > 1
        names = [name for name in self._names if several or len(self._model.moved[name]) > 1]
        for number in range(_ROUNDS if names else 0):
            for name in names:
                trials = (self._pose[name], *self._trials(name, _RANGE_FACTOR**number))
                self._move(name, max(trials, key=partial(self._value_at, name)))
            self.torque = self._sign * self._value()
            if not several:
                self._climb()

    def _trials(self, name: str, part: float) -> list[float]:
        """The best position, or several candidates in a part of the range of a mimicked joint."""
        low, high = self._model.spans[name]
        if not self._is_free(name):
            reach = part * (high - low)
            start = min(max(self._pose[name] - reach / 2, low), high - reach)
            return [start + reach * n / (_TRIALS - 1) for n in range(_TRIALS)]
        if not self._bodies[self._model.moved[name][0]].is_rotational:
            return [low, high]
        first, second, third = (self._value_at(name, angle) for angle in (0.0, pi / 2, pi))
        middle = (first + third) / 2
        return [best_angle(first - middle, second - middle, (low, high))]

    def pose_at_rest(self) -> dict[str, float]:
        """The nonzero positions, after joints that hardly change the torque were moved to rest."""
        slack = NEGLIGIBLE * self.torque
        for name in self._names if len(self._names) <= MAX_RESTED else ():
            position, value = self._pose[name], self._sign * self._value()
            loss = value - self._value_at(name, nearest_to_zero(self._model.spans[name]))
            if loss > slack:
                self._move(name, position)
            else:
                slack -= loss
        return {name: self._pose[name] for name in self._names if self._pose[name]}

    def _climb(self) -> None:
        """Sweep until there is no gain."""
        for _ in range(MAX_SWEEPS):
            before, self.torque = self.torque, self._sweep()
            if self.torque <= before * (1 + _MIN_GAIN) or self.steps > self._budget:
                break

    def _sweep(self) -> float:
        """Choose the best position of each unmimicked joint, below and above; return the torque."""
        (target,) = self._targets
        path, body = self._paths[target], self._bodies[target]
        self.steps += len(path) + len(self._model.below(target))
        directions, up = self._ups(path)
        moment = body.moment
        if body.is_rotational:
            moment = self._moment(target, times(cross(up, body.axis), self._sign))
        lever = times(self._model.lever(target, moment), self._sign)
        for number, direction in zip(reversed(path), reversed(directions), strict=True):
            joint_body = self._bodies[number]
            if joint_body.is_rotational:
                self._choose(number, direction, lever)
                lever = rotated(joint_body, lever, self._positions[number])
            lever = rotate(joint_body.at.rotation, lever)
        return lever[2]

    def _moment(self, target: int, along: Vector | None = None) -> Vector:
        """First moment of a body and its descendants.

        If ``along`` is given, positions are chosen that maximise the component along this vector.
        """
        below = self._model.below(target)
        moments = {number: self._bodies[number].moment for number in below}
        directions: dict[int, Vector] = {}
        local = {target: along or ORIGIN}
        for number in below[1:] if along else ():
            body = self._bodies[number]
            directions[number] = rotate(body.from_parent, local[body.parent])
            local[number] = rotated(body, directions[number], -self._positions[number])
        for number in reversed(below[1:]):
            if along:
                self._choose(number, directions[number], moments[number])
            self._model.add_to_parent(number, self._positions[number], moments)
        return moments[target]

    def _choose(self, number: int, x: Vector, y: Vector) -> None:
        """Move the joint of a body to maximise the torque, ``x . R y`` up to a constant.

        For a prismatic joint, it is ``x . axis`` times the carried mass and the position.
        """
        body = self._bodies[number]
        name, k = body.law.leader, body.axis
        if not self._is_free(name):
            return
        low, high = self._model.spans[name]
        if not body.is_rotational:
            if along := dot(x, k) * self._model.carried_mass[number]:
                self._move(name, high if along > 0 else low)
            return
        a, b = dot(x, y) - dot(k, x) * dot(k, y), dot(x, cross(k, y))
        if a or b:
            self._move(name, best_angle(a, b, (low, high)))

    def _value_at(self, name: str, position: float) -> float:
        self._move(name, position)
        return self._sign * self._value()

    def _value(self) -> float:
        """The torque divided by g."""
        total = 0.0
        for target in self._targets:
            lever = self._model.lever(target, self._moment(target))
            total += self._bodies[target].law.factor * dot(lever, self._ups(self._paths[target])[1])
        return total

    def _ups(self, path: list[int]) -> tuple[list[Vector], Vector]:
        """The upward direction in the frame of each joint of a path, and of the last body."""
        up, directions = Z_AXIS, []
        for number in path:
            body = self._bodies[number]
            directions.append(rotate(body.from_parent, up))
            up = rotated(body, directions[-1], -self._positions[number])
        return directions, up

    def _path(self, target: int) -> list[int]:
        """The bodies from the root (exclusive) to a body."""
        path = []
        while self._bodies[target].parent >= 0:
            path.append(target)
            target = self._bodies[target].parent
        return path[::-1]

    def _move(self, name: str, position: float) -> None:
        self._pose[name] = position
        for number in self._model.moved[name]:
            law = self._bodies[number].law
            self._positions[number] = law.factor * position + law.shift

    def _is_free(self, name: str) -> bool:
        """True for a joint that no other joint mimics."""
        return len(self._model.moved.get(name, ())) == 1


def find_worst(
    model: GravityModel, name: str, starts: Iterable[Mapping[str, float]], budget: int
) -> tuple[float, dict[str, float]]:
    """The largest absolute torque of a joint, and the positions that matter to it.

    Args:
        name: name of an independent joint.
        starts: poses in which climbs begin.
        budget: steps of all climbs; the first climb always has one sweep.
    """
    climbs: list[_Climb] = []
    for start in starts:
        if not climbs or budget > 0:
            climbs.append(_Climb(model, name, start, budget))
            budget -= climbs[-1].steps
    highest = sorted(climbs, key=lambda climb: -climb.torque)[:_MAX_REFINED]
    for climb in highest:
        climb.refine()
    best = max(highest, key=lambda climb: climb.torque)
    return GRAVITY * abs(best.torque), best.pose_at_rest()  # rounding may be below 0


def is_searched(joints: int) -> bool:
    """False for too many joints to search for their worst poses."""
    return joints <= MAX_SEARCHED


def gravity_loads(
    model: GravityModel,
    efforts: Mapping[str, float | None],
    starts: Sequence[Mapping[str, float]],
    pose: Mapping[str, float],
    progress: Progress | None = None,
) -> list[Load]:
    """The gravity loads of joints, sorted by the used part of the effort limit, largest first.

    Args:
        efforts: effort limits by joint name, in N·m or N; None if undefined. Joints that are not
            independent, or have several degrees of freedom, are omitted.
        starts: poses; the first one is zero, and climbs begin in the worst ones.
        progress: called with the number of finished joints and of all.
    """
    torques = [model.torques(start) for start in starts]
    names = [name for name in model.moved if name in efforts]
    at_pose = model.torques(pose)
    budget = MAX_STEPS // max(1, len(names))
    loads: list[Load] = []
    for name in names:
        if progress:
            progress(len(loads), len(names))
        largest, worst_pose = abs(torques[0][name]), dict[str, float]()
        if is_searched(len(names)):
            order = sorted(range(len(starts)), key=lambda n: -abs(torques[n][name]))
            best_starts = [starts[n] for n in order[:MAX_CLIMBS]]
            largest, worst_pose = find_worst(model, name, best_starts, budget)
        fixed_loads = torques[0][name], at_pose[name]
        loads.append(Load(name, efforts[name], *fixed_loads, largest, worst_pose))
    return sorted(loads, key=lambda load: (-(load.used or 0.0), -load.worst))

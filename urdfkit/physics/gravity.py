"""The gravity loads of joints, and the poses in which they are largest.

In the angle ``q`` of another joint a torque is ``c + a cos q + b sin q``, and in the way of a slide
it is linear: the best position of one joint, the others held, is a closed form. A sweep finds it
for all joints above and below, one after another, at a cost that grows with their number.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from math import pi

from urdfkit.core.progress import Progress
from urdfkit.core.record import Record
from urdfkit.core.spatial import ORIGIN, Vector, cross, dot, rotate, times
from urdfkit.physics.gravity_model import UP, GravityModel, rest, turned
from urdfkit.robot.joint_loads import GRAVITY
from urdfkit.robot.kinematics import best_angle

#: Climbs for each joint, and sweeps of one.
CLIMBS, SWEEPS = 24, 30

#: Steps of all climbs together: an arm needs some hundreds, and a chain of a hundred joints is no
#: robot that is worth seconds.
BUDGET = 60_000

#: Joints up to which the worst pose is searched, which takes the square of their number; the loads
#: of more joints are those at zero.
MAX_SEARCHED = 300

#: A pose is reported without what changes its torque by less than this part.
ASIDE = 1e-4

#: Joints of a pose up to which those at rest are left out, which takes the square of their number.
MAX_RESTED = 50

#: Positions that are tried of joints that others mimic, in rounds, each in a smaller part of the
#: limits.
_TRIALS, _ROUNDS, _NARROWER = 17, 6, 0.25

#: Climbs that go on with such trials.
_REFINED = 3

#: A sweep or a round that gains less, relatively, is the last.
_LEAST = 1e-9


class Load(Record):
    """The gravity load of one joint."""

    joint: str  # its name
    effort: float | None  # what it can exert, in N·m or N; None where the model does not say
    at_zero: float  # what it holds with all joints at zero; the sign is that of its axis
    at_pose: float  # what it holds at the pose that was asked for; that at zero if none was
    worst: float  # the largest of all poses, without sign: the effort that suffices
    #: In which it does, in rad or m; joints that hardly matter there are at rest, and those at 0,
    #: or on another branch of the tree, are left out.
    pose: dict[str, float]

    @property
    def used(self) -> float | None:
        """The part of its effort that the worst pose takes."""
        return None if self.effort is None else self.worst / self.effort

    @property
    def is_exceeded(self) -> bool:
        """True if no controller can hold the worst pose."""
        return self.used is not None and self.used > 1


class _Climb:
    """The search for the largest torque of one joint, from one pose.

    Args:
        start: positions of joints.
        budget: steps after which no sweep begins.
    """

    def __init__(
        self, model: GravityModel, name: str, start: Mapping[str, float], budget: int
    ) -> None:
        self._model = model
        self._bodies = model.bodies
        self._targets = model.moved[name]
        self._places = model.places(start)
        self._pose = dict(start)
        self._paths = {target: self._path(target) for target in self._targets}
        self._names = dict.fromkeys(
            model.bodies[number].law.leader
            for target in self._targets
            for number in (*self._paths[target], *model.below(target))
        )
        self._names.pop("", None)
        self.steps = 0  # bodies that were looked at
        self._budget = budget
        value = self._value()
        self._sign = 1.0 if value >= 0 else -1.0
        self.torque = abs(value)  # what was found, without sign, in units of gravity
        if len(self._targets) == 1:
            self._climb()

    def refine(self) -> None:
        """Try positions of the joints that others mimic, and of all if others mimic this one."""
        several = len(self._targets) > 1
        names = [name for name in self._names if several or len(self._model.moved[name]) > 1]
        for number in range(_ROUNDS if names else 0):
            for name in names:
                trials = (self._pose[name], *self._trials(name, _NARROWER**number))
                self._move(name, max(trials, key=partial(self._value_at, name)))
            self.torque = self._sign * self._value()
            if not several:
                self._climb()

    def _trials(self, name: str, part: float) -> list[float]:
        """The best position, or several in a part of the limits if others mimic the joint."""
        low, high = self._model.spans[name]
        if not self._is_free(name):
            reach = part * (high - low)
            start = min(max(self._pose[name] - reach / 2, low), high - reach)
            return [start + reach * n / (_TRIALS - 1) for n in range(_TRIALS)]
        if not self._bodies[self._model.moved[name][0]].turns:
            return [low, high]
        first, second, third = (self._value_at(name, angle) for angle in (0.0, pi / 2, pi))
        middle = (first + third) / 2
        return [best_angle(first - middle, second - middle, (low, high))]

    def rested(self) -> dict[str, float]:
        """The positions that are not 0, with all joints at rest that hardly change the torque."""
        slack = ASIDE * self.torque
        for name in self._names if len(self._names) <= MAX_RESTED else ():
            kept, now = self._pose[name], self._sign * self._value()
            loss = now - self._value_at(name, rest(self._model.spans[name]))
            if loss > slack:
                self._move(name, kept)
            else:
                slack -= loss
        return {name: self._pose[name] for name in self._names if self._pose[name]}

    def _climb(self) -> None:
        """Sweep until nothing is gained."""
        for _ in range(SWEEPS):
            before, self.torque = self.torque, self._sweep()
            if self.torque <= before * (1 + _LEAST) or self.steps > self._budget:
                break

    def _sweep(self) -> float:
        """Choose the position of each joint that moves alone, below and above; the torque then."""
        (target,) = self._targets
        way, body = self._paths[target], self._bodies[target]
        self.steps += len(way) + len(self._model.below(target))
        befores, up = self._ups(way)
        moment = body.moment
        if body.turns:
            moment = self._moment(target, times(cross(up, body.axis), self._sign))
        wanted = times(self._model.lever(target, moment), self._sign)
        for number, before in zip(reversed(way), reversed(befores), strict=True):
            one = self._bodies[number]
            if one.turns:
                self._choose(number, before, wanted)
                wanted = turned(one, wanted, self._places[number])
            wanted = rotate(one.at.rotation, wanted)
        return wanted[2]

    def _moment(self, target: int, wanted: Vector | None = None) -> Vector:
        """Of all that a body carries; the positions are chosen for its part along a vector."""
        below = self._model.below(target)
        moments = {number: self._bodies[number].moment for number in below}
        befores: dict[int, Vector] = {}
        along = {target: wanted or ORIGIN}
        for number in below[1:] if wanted else ():
            body = self._bodies[number]
            befores[number] = rotate(body.back, along[body.parent])
            along[number] = turned(body, befores[number], -self._places[number])
        for number in reversed(below[1:]):
            if wanted:
                self._choose(number, befores[number], moments[number])
            self._model.hand_up(number, self._places[number], moments)
        return moments[target]

    def _choose(self, number: int, x: Vector, y: Vector) -> None:
        """Move the joint of a body to where the torque, ``x . R y`` up to a constant, is largest.

        Of a slide it is ``x . axis`` times the mass that it carries and its way.
        """
        body = self._bodies[number]
        name, k = body.law.leader, body.axis
        if not self._is_free(name):
            return
        low, high = self._model.spans[name]
        if not body.turns:
            if along := dot(x, k) * self._model.carried[number]:
                self._move(name, high if along > 0 else low)
            return
        a, b = dot(x, y) - dot(k, x) * dot(k, y), dot(x, cross(k, y))
        if a or b:
            self._move(name, best_angle(a, b, (low, high)))

    def _value_at(self, name: str, place: float) -> float:
        self._move(name, place)
        return self._sign * self._value()

    def _value(self) -> float:
        """The torque in units of gravity."""
        total = 0.0
        for target in self._targets:
            lever = self._model.lever(target, self._moment(target))
            total += self._bodies[target].law.factor * dot(lever, self._ups(self._paths[target])[1])
        return total

    def _ups(self, way: list[int]) -> tuple[list[Vector], Vector]:
        """The direction upwards in the frame of each joint of a way, and of the last body."""
        up, befores = UP, []
        for number in way:
            body = self._bodies[number]
            befores.append(rotate(body.back, up))
            up = turned(body, befores[-1], -self._places[number])
        return befores, up

    def _path(self, target: int) -> list[int]:
        """The bodies from the root, without it, to one of them."""
        found = []
        while self._bodies[target].parent >= 0:
            found.append(target)
            target = self._bodies[target].parent
        return found[::-1]

    def _move(self, name: str, place: float) -> None:
        self._pose[name] = place
        for number in self._model.moved[name]:
            law = self._bodies[number].law
            self._places[number] = law.factor * place + law.shift

    def _is_free(self, name: str) -> bool:
        """True for a joint that no other one mimics."""
        return len(self._model.moved.get(name, ())) == 1


def worst(
    model: GravityModel, name: str, starts: Iterable[Mapping[str, float]], budget: int
) -> tuple[float, dict[str, float]]:
    """The largest torque of a joint, without sign, and the positions that matter to it.

    Args:
        name: of a joint that is set by one number.
        starts: poses in which climbs begin.
        budget: steps of all climbs; the first one has its first sweep in any case.
    """
    climbs: list[_Climb] = []
    for start in starts:
        if not climbs or budget > 0:
            climbs.append(_Climb(model, name, start, budget))
            budget -= climbs[-1].steps
    highest = sorted(climbs, key=lambda climb: -climb.torque)[:_REFINED]
    for climb in highest:
        climb.refine()
    best = max(highest, key=lambda climb: climb.torque)
    return GRAVITY * best.torque, best.rested()


def is_searched(joints: int) -> bool:
    """False for so many joints that their loads are those at zero."""
    return joints <= MAX_SEARCHED


def gravity_loads(
    model: GravityModel,
    efforts: Mapping[str, float | None],
    starts: Sequence[Mapping[str, float]],
    pose: Mapping[str, float],
    progress: Progress | None = None,
) -> list[Load]:
    """The gravity loads of some joints, those first that use the largest part of their effort.

    Args:
        efforts: of the joints that are judged, in N·m or N, by name; None where the model does not
            say. Joints that cannot be set by one number are left out.
        starts: poses; the first one is zero, and climbs begin in the worst ones.
        progress: called with the number of joints done and of all.
    """
    torques = [model.torques(start) for start in starts]
    names = [name for name in model.moved if name in efforts]
    at_pose = model.torques(pose)
    budget = BUDGET // max(1, len(names))
    found: list[Load] = []
    for name in names:
        if progress:
            progress(len(found), len(names))
        largest, where = abs(torques[0][name]), dict[str, float]()
        if is_searched(len(names)):
            order = sorted(range(len(starts)), key=lambda n: -abs(torques[n][name]))
            largest, where = worst(model, name, [starts[n] for n in order[:CLIMBS]], budget)
        held = torques[0][name], at_pose[name]
        found.append(Load(name, efforts[name], *held, largest, where))
    return sorted(found, key=lambda load: (-(load.used or 0.0), -load.worst))

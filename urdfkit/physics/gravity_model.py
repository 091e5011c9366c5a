"""The moving bodies of a robot, and the gravity torques of its joints in a pose.

With ``u`` the direction upwards and ``s`` the first moment of all mass that a joint carries about
its origin, both in the frame of its child, a joint that turns about ``a`` holds ``g u . (a x s)``,
and a slide ``g m a . u``. Lengths in m, angles in rad, masses in kg; the root is held.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import cos, sin

from urdfkit.core.record import Record
from urdfkit.core.spatial import (
    ORIGIN,
    Rotation,
    Transform,
    Vector,
    cross,
    dot,
    plus,
    rotate,
    times,
    transposed,
)
from urdfkit.robot.joint_loads import GRAVITY
from urdfkit.robot.joints import span
from urdfkit.robot.kinematics import LOCKED, SLIDING, TURNING, MimicLaw, direction, laws
from urdfkit.robot.rigid_bodies import RigidBody, rigid_bodies
from urdfkit.robot.tree import KinematicTree

UP: Vector = (0.0, 0.0, 1.0)


class MovingBody(Record):
    """Links that are fixed to one another and move as one body."""

    parent: int  # number of the body that carries it; -1 for that of the root
    at: Transform  # the frame of its joint in that of the parent
    back: Rotation  # the inverse of the rotation of that frame
    axis: Vector  # of the joint, a unit vector
    turns: bool  # True for an angle; False for a way, and where nothing moves it
    law: MimicLaw  # what the position of the joint follows; of no leader if it stays where it is
    mass: float  # of the links
    moment: Vector  # the first moment of their mass about the origin of the body


class GravityModel:
    """The moving bodies of a robot; two models of the same bodies are equal.

    Args:
        tree: of a sound model.
        payload: masses that links carry at their origin, besides their own, by name.
        weightless: names of links whose own mass does not count.
    """

    def __init__(
        self,
        tree: KinematicTree,
        payload: Mapping[str, float] | None = None,
        weightless: Collection[str] = (),
    ) -> None:
        joints = tree.model.joints_by_name
        self.bodies = _bodies(tree, payload or {}, weightless)  # each after that which carries it
        #: The mass of each body and of all that it carries.
        self.carried = [body.mass for body in self.bodies]
        self._children: list[list[int]] = [[] for _ in self.bodies]
        for number in range(len(self.bodies) - 1, 0, -1):
            parent = self.bodies[number].parent
            self.carried[parent] += self.carried[number]
            self._children[parent].append(number)
        #: The bodies that move with each joint that is set by one number, by its name.
        self.moved: dict[str, list[int]] = {}
        for number, body in enumerate(self.bodies):
            if body.law.leader:
                self.moved.setdefault(body.law.leader, []).append(number)
        #: From where to where that joint moves.
        self.spans = {name: span(joints[name]) for name in self.moved}
        self._key = (tuple(self.bodies), tuple(self.spans.items()))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, GravityModel) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    def below(self, number: int) -> list[int]:
        """A body and those that it carries, parents before children."""
        found, left = [], [number]
        while left:
            found.append(left.pop())
            left += reversed(self._children[found[-1]])
        return found

    def torques(self, pose: Mapping[str, float]) -> dict[str, float]:
        """What each joint holds that is set by one number, in N·m or N, with the sign of its axis.

        Args:
            pose: positions of these joints; the others are at 0.
        """
        places = self.places(pose)
        ups = [UP] * len(self.bodies)
        for number, body in enumerate(self.bodies):
            if body.parent >= 0:
                ups[number] = turned(body, rotate(body.back, ups[body.parent]), -places[number])
        moments = {number: body.moment for number, body in enumerate(self.bodies)}
        for number in range(len(self.bodies) - 1, 0, -1):
            self.hand_up(number, places[number], moments)
        return {
            name: GRAVITY
            * sum(self.bodies[n].law.factor * dot(self.lever(n, moments[n]), ups[n]) for n in moved)
            for name, moved in self.moved.items()
        }

    def starts(self, samples: int, seed: int) -> list[dict[str, float]]:
        """Zero, or what is nearest to it; all joints at their ends; poses drawn between these."""
        from random import Random  # which takes 2 ms to import

        random = Random(seed)
        spans = self.spans.items()
        return [
            {name: 0.0 for name, _ in spans},
            {name: rest(ends) for name, ends in spans},
            *({name: ends[side] for name, ends in spans} for side in (0, 1)),
            *({name: random.uniform(*ends) for name, ends in spans} for _ in range(samples)),
        ]

    def places(self, pose: Mapping[str, float]) -> list[float]:
        return [b.law.factor * pose.get(b.law.leader, 0.0) + b.law.shift for b in self.bodies]

    def lever(self, number: int, moment: Vector) -> Vector:
        """The vector whose part upwards is the torque or force of a joint, without gravity."""
        body, mass = self.bodies[number], self.carried[number]
        return cross(body.axis, moment) if body.turns else times(body.axis, mass)

    def hand_up(self, number: int, place: float, moments: dict[int, Vector]) -> None:
        """Add the moment of a body, at a position of its joint, to that of the one below it."""
        body, mass = self.bodies[number], self.carried[number]
        moved = turned(body, moments[number], place)
        if not body.turns:
            moved = plus(moved, times(body.axis, place * mass))
        moved = rotate(body.at.rotation, moved)
        whole = plus(moments[body.parent], plus(moved, times(body.at.position, mass)))
        moments[body.parent] = whole


def _bodies(
    tree: KinematicTree, payload: Mapping[str, float], weightless: Collection[str]
) -> list[MovingBody]:
    """The bodies of a tree, each after that which carries it."""
    followed = laws(tree.model.joints_by_name)
    joints = tree.model.joints_by_name
    placed: dict[str, tuple[int, Transform]] = {}
    found: list[MovingBody] = []
    for body in rigid_bodies(tree):
        placed.update((link.name, (len(found), frame)) for link, frame in body.links)
        mass, moment = _load(body, payload, weightless)
        joint, parent, at, law, axis, turns = body.joint, -1, Transform(), LOCKED, UP, False
        if joint is not None:
            parent, frame = placed[joint.parent_name]
            at, axis, turns = frame @ joint.origin, direction(joint), joint.kind in TURNING
            if joint.kind in (*TURNING, *SLIDING):
                law = followed[joint.name]
                if law.leader not in joints or joints[law.leader].kind not in (*TURNING, *SLIDING):
                    law = MimicLaw("", 0.0, law.shift)
        back = transposed(at.rotation)
        found.append(MovingBody(parent, at, back, axis, turns, law, mass, moment))
    return found


def _load(
    body: RigidBody, payload: Mapping[str, float], weightless: Collection[str]
) -> tuple[float, Vector]:
    """The mass of a body and its payload in kg, and their first moment in the frame of its top."""
    mass, moment = 0.0, ORIGIN
    for link, frame in body.links:
        own = 0.0 if link.name in weightless else link.mass
        if link.inertial:
            moment = plus(moment, times((frame @ link.inertial.origin).position, own))
        extra = payload.get(link.name, 0.0)
        moment = plus(moment, times(frame.position, extra))
        mass += own + extra
    return mass, moment


def rest(ends: tuple[float, float]) -> float:
    """The position nearest to 0 between two ends."""
    return min(max(0.0, ends[0]), ends[1])


def turned(body: MovingBody, vector: Vector, angle: float) -> Vector:
    """A vector turned about the axis of a body's joint, if it turns (Rodrigues' formula)."""
    if not body.turns or not angle:
        return vector
    c, s, k = cos(angle), sin(angle), body.axis
    along = (1 - c) * dot(k, vector)
    x, y, z = cross(k, vector)
    return (
        vector[0] * c + x * s + k[0] * along,
        vector[1] * c + y * s + k[1] * along,
        vector[2] * c + z * s + k[2] * along,
    )

"""The moving bodies of a robot, and the gravity torques of its joints in a pose.

With ``u`` the upward direction and ``s`` the first moment of all mass that a joint carries about
its origin, both in the frame of its child, a revolute joint about ``a`` bears ``g u . (a x s)``,
and a prismatic joint ``g m a . u``. Lengths in m, angles in rad, masses in kg; the root is fixed.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from math import cos, sin

from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.spatial import (
    ORIGIN,
    Z_AXIS,
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
from urdfkit.robot.joint_limits import span
from urdfkit.robot.joint_loads import GRAVITY
from urdfkit.robot.kinematics import LOCKED, MimicLaw, direction, laws
from urdfkit.robot.rigid_bodies import RigidBody, rigid_bodies
from urdfkit.robot.tree import KinematicTree


class MovingBody(Record):
    """Links that fixed joints connect to one body."""

    parent: int  # number of the parent body; -1 for the body of the root
    at: Transform  # frame of the joint in the parent
    from_parent: Rotation  # inverse rotation of that frame
    axis: Vector  # of the joint, a unit vector
    is_rotational: bool  # True for an angle; False for a distance and for an immobile body
    law: MimicLaw  # of the position of the joint; without a leader for an immobile joint
    mass: float  # of the links
    moment: Vector  # first moment of their mass about the origin of the body


class GravityModel:
    """The moving bodies of a robot; two models of the same bodies are equal.

    Args:
        tree: of a valid model.
        payload: additional masses at the origins of links, by link name.
        weightless: names of links whose own mass is ignored.
    """

    def __init__(
        self,
        tree: KinematicTree,
        payload: Mapping[str, float] | None = None,
        weightless: Collection[str] = (),
    ) -> None:
        joints = tree.model.joints_by_name
        self.bodies = _bodies(tree, payload or {}, weightless)  # parents first
        #: Mass of each body and its descendants.
        self.carried_mass = [body.mass for body in self.bodies]
        self._children: list[list[int]] = [[] for _ in self.bodies]
        for number in range(len(self.bodies) - 1, 0, -1):
            parent = self.bodies[number].parent
            self.carried_mass[parent] += self.carried_mass[number]
            self._children[parent].append(number)
        #: Bodies that move with each independent joint of one degree of freedom, by its name.
        self.moved = by_key(
            (body.law.leader, number) for number, body in enumerate(self.bodies) if body.law.leader
        )
        #: Range of each of these joints.
        self.spans = {name: span(joints[name]) for name in self.moved}
        self._key = (tuple(self.bodies), tuple(self.spans.items()))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, GravityModel) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)

    def below(self, number: int) -> list[int]:
        """A body and its descendants, parents before children."""
        subtree, stack = [], [number]
        while stack:
            subtree.append(stack.pop())
            stack += reversed(self._children[subtree[-1]])
        return subtree

    def torques(self, pose: Mapping[str, float]) -> dict[str, float]:
        """Load of each independent joint, in N·m or N, with the sign of its axis.

        Args:
            pose: positions of these joints; the others are at 0.
        """
        positions = self.positions(pose)
        ups = [Z_AXIS] * len(self.bodies)
        for number, body in enumerate(self.bodies):
            if body.parent >= 0:
                up = rotate(body.from_parent, ups[body.parent])
                ups[number] = rotated(body, up, -positions[number])
        moments = {number: body.moment for number, body in enumerate(self.bodies)}
        for number in range(len(self.bodies) - 1, 0, -1):
            self.add_to_parent(number, positions[number], moments)
        return {
            name: GRAVITY
            * sum(self.bodies[n].law.factor * dot(self.lever(n, moments[n]), ups[n]) for n in moved)
            for name, moved in self.moved.items()
        }

    def starts(self, samples: int, seed: int) -> list[dict[str, float]]:
        """Zero; the nearest valid pose to it; all joints at their limits; and random poses."""
        from random import Random  # takes 2 ms to import

        random = Random(seed)
        spans = self.spans.items()
        return [
            {name: 0.0 for name, _ in spans},
            {name: nearest_to_zero(ends) for name, ends in spans},
            *({name: ends[side] for name, ends in spans} for side in (0, 1)),
            *({name: random.uniform(*ends) for name, ends in spans} for _ in range(samples)),
        ]

    def positions(self, pose: Mapping[str, float]) -> list[float]:
        return [b.law.factor * pose.get(b.law.leader, 0.0) + b.law.shift for b in self.bodies]

    def lever(self, number: int, moment: Vector) -> Vector:
        """The vector whose upward component times g is the torque or force of a joint."""
        body, mass = self.bodies[number], self.carried_mass[number]
        return cross(body.axis, moment) if body.is_rotational else times(body.axis, mass)

    def add_to_parent(self, number: int, position: float, moments: dict[int, Vector]) -> None:
        """Add the moment of a body, at a position of its joint, to the moment of its parent."""
        body, mass = self.bodies[number], self.carried_mass[number]
        moved = rotated(body, moments[number], position)
        if not body.is_rotational:
            moved = plus(moved, times(body.axis, position * mass))
        moved = rotate(body.at.rotation, moved)
        moved = plus(moved, times(body.at.position, mass))
        moments[body.parent] = plus(moments[body.parent], moved)


def _bodies(
    tree: KinematicTree, payload: Mapping[str, float], weightless: Collection[str]
) -> list[MovingBody]:
    """The bodies of a tree, parents first."""
    followed = laws(tree.model.joints_by_name)
    joints = tree.model.joints_by_name
    placed: dict[str, tuple[int, Transform]] = {}
    bodies: list[MovingBody] = []
    for body in rigid_bodies(tree):
        placed.update((link.name, (len(bodies), frame)) for link, frame in body.links)
        mass, moment = _load(body, payload, weightless)
        joint = body.joint
        if joint is None:
            at, axis = Transform(), Z_AXIS
            bodies.append(MovingBody(-1, at, at.rotation, axis, False, LOCKED, mass, moment))
            continue
        law = followed[joint.name] if joint.is_single_dof else LOCKED
        if law.leader not in joints or not joints[law.leader].is_single_dof:
            law = MimicLaw("", 0.0, law.shift)
        parent, frame = placed[joint.parent_name]
        at, axis = frame @ joint.origin, direction(joint)
        back = transposed(at.rotation)
        bodies.append(MovingBody(parent, at, back, axis, joint.is_rotational, law, mass, moment))
    return bodies


def _load(
    body: RigidBody, payload: Mapping[str, float], weightless: Collection[str]
) -> tuple[float, Vector]:
    """Mass of a body with payload, and its first moment in the frame of its topmost link."""
    mass, moment = 0.0, ORIGIN
    for link, frame in body.links:
        own = 0.0 if link.name in weightless else link.mass
        if link.inertial:
            moment = plus(moment, times((frame @ link.inertial.origin).position, own))
        extra = payload.get(link.name, 0.0)
        moment = plus(moment, times(frame.position, extra))
        mass += own + extra
    return mass, moment


def nearest_to_zero(ends: tuple[float, float]) -> float:
    """The position nearest to 0 between two ends."""
    return min(max(0.0, ends[0]), ends[1])


def rotated(body: MovingBody, vector: Vector, angle: float) -> Vector:
    """A vector rotated about the axis of a body's joint, if it is revolute (Rodrigues' formula)."""
    if not body.is_rotational or not angle:
        return vector
    c, s, k = cos(angle), sin(angle), body.axis
    along = (1 - c) * dot(k, vector)
    x, y, z = cross(k, vector)
    return (
        vector[0] * c + x * s + k[0] * along,
        vector[1] * c + y * s + k[1] * along,
        vector[2] * c + z * s + k[2] * along,
    )

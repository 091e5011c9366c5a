"""Reach of a robot: the largest distance of the end of a chain from its first joint.

For an arm this is the radius of its workspace as in data sheets. Lengths in m.
"""

from __future__ import annotations

from math import cos, hypot, isfinite, sin
from random import Random

from urdfkit.core.record import Record
from urdfkit.core.spatial import ORIGIN, Transform, Vector, cross, dot, minus, plus, times
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import span
from urdfkit.robot.kinematics import best_angle, direction
from urdfkit.robot.tree import KinematicTree

#: Limits of joints in a chain and of chains; hands have chains for each finger.
MAX_JOINTS, MAX_CHAINS = 200, 50

#: Start poses of the search besides the zero pose, and its largest number of rounds.
STARTS, ROUNDS = 12, 200

#: Relative growth of the distance in a round below which the search ends.
GROWTH = 1e-9


class Reach(Record):
    """The chain with the longest reach."""

    distance: float  # from the first moving joint to the origin of the last link, in m
    joint: str  # the first moving joint
    link: str  # the last link
    pose: dict[str, float]  # positions of the chain's joints at this distance, in rad or m


def reach(tree: KinematicTree) -> Reach | None:
    """The longest reach of all chains; None without moving joints.

    Mimic joints count as independent within their limits.
    """
    chains = [
        chain for chain in _chains(tree) if len(chain) <= MAX_JOINTS and isfinite(_length(chain))
    ]
    chains.sort(key=_length, reverse=True)
    best: Reach | None = None
    for chain in chains[:MAX_CHAINS]:
        if best is None or _length(chain) > best.distance:
            candidate = _reach(chain)
            if best is None or candidate.distance > best.distance:
                best = candidate
    return best


def _chains(tree: KinematicTree) -> list[list[Joint]]:
    """The chains from the first moving joints to the leaves of the tree."""
    chains: list[list[Joint]] = []
    for end, joints in tree.children.items():
        if joints:
            continue
        chain: list[Joint] = []
        above = tree.parents[end]
        while above and len(chain) <= MAX_JOINTS:
            chain.append(above[0])
            above = tree.parents[above[0].parent_name]
        while chain and not chain[-1].is_single_dof:
            chain.pop()
        if chain:
            chains.append(chain[::-1])
    return chains


def _length(chain: list[Joint]) -> float:
    """Upper bound of the reach: the length of the straightened chain."""
    travel = sum(max(map(abs, span(joint))) for joint in chain if joint.is_prismatic)
    return travel + sum(hypot(*joint.origin.position) for joint in chain[1:])


class _Axis(Record):
    """A moving joint of a chain."""

    joint: Joint
    direction: Vector  # unit vector of its axis
    to_next: Transform  # the frame of the next moving joint, or of the tip, in that of the child
    from_next: Transform  # its inverse

    def moved(self, point: Vector, position: float) -> Vector:
        """A point of the child, in the frame of the joint (Rodrigues' formula)."""
        if self.joint.is_prismatic:
            return plus(point, times(self.direction, position))
        c, s = cos(position), sin(position)
        along = times(self.direction, (1 - c) * dot(self.direction, point))
        return plus(plus(times(point, c), times(cross(self.direction, point), s)), along)


def _axes(chain: list[Joint]) -> list[_Axis]:
    """The moving joints of a chain, of which the first joint is one."""
    axes: list[_Axis] = []
    following = Transform()
    for joint in reversed(chain):
        if joint.is_single_dof:
            axes.append(_Axis(joint, direction(joint), following, following.inverse))
            following = joint.origin
        else:
            following = joint.origin @ following
    return axes[::-1]


def _reach(chain: list[Joint]) -> Reach:
    """Coordinate ascent from several poses; each joint has its optimum in closed form."""
    axes = _axes(chain)
    ranges = [span(axis.joint) for axis in axes]
    random = Random(0)
    starts = [[min(max(0.0, low), high) for low, high in ranges]]
    starts += [[random.uniform(*ends) for ends in ranges] for _ in range(STARTS)]
    optima = [_climb(axes, ranges, start) for start in starts]
    distance, pose = max(optima, key=lambda optimum: optimum[0])
    named = {axis.joint.name: position for axis, position in zip(axes, pose, strict=True)}
    return Reach(distance, chain[0].name, chain[-1].child_name, named)


def _climb(
    axes: list[_Axis], ranges: list[tuple[float, float]], pose: list[float]
) -> tuple[float, list[float]]:
    """Rounds over the joints until the distance does not grow."""
    pose, best = list(pose), -1.0
    for _ in range(ROUNDS):
        bases = _bases(axes, pose)
        tip: Vector = ORIGIN
        for index in range(len(axes) - 1, -1, -1):
            axis = axes[index]
            tip = axis.to_next.apply(tip)
            pose[index] = _best(axis, ranges[index], bases[index], tip, pose[index])
            tip = axis.moved(tip, pose[index])
        distance = hypot(*tip)
        if not distance > best * (1 + GROWTH):
            break
        best = distance
    return max(best, distance), pose


def _bases(axes: list[_Axis], pose: list[float]) -> list[Vector]:
    """The position of the first joint, in the frame of each joint at zero."""
    bases: list[Vector] = [ORIGIN]
    for axis, position in zip(axes[:-1], pose, strict=False):
        bases.append(axis.from_next.apply(axis.moved(bases[-1], -position)))
    return bases


def _best(axis: _Axis, ends: tuple[float, float], base: Vector, tip: Vector, now: float) -> float:
    """The position of a joint that maximises the distance of the tip from the base.

    The squared distance is ``a - 2 (b cos q + c sin q)`` for an angle q (Rodrigues' formula), and a
    parabola that opens upwards for a prismatic joint.
    """
    if axis.joint.is_prismatic:
        along = dot(axis.direction, minus(tip, base))
        return max(ends, key=lambda q: abs(q + along))
    b = dot(base, tip) - dot(axis.direction, base) * dot(axis.direction, tip)
    c = dot(base, cross(axis.direction, tip))
    if b * b + c * c <= 1e-24 * dot(base, base) * dot(tip, tip):
        return now  # the rotation does not change the distance
    return best_angle(-b, -c, ends)

"""How far a robot reaches: the farthest that the end of a chain gets from its first joint.

For an arm this is the radius of its workspace as data sheets have it. Lengths in m.
"""

from __future__ import annotations

from math import hypot, isfinite
from random import Random

from urdfkit.core.record import Record
from urdfkit.core.spatial import ORIGIN, Vector, cross, dot, minus
from urdfkit.robot.joints import span
from urdfkit.robot.kinematics import SLIDING, TURNING, best_angle, direction, motion
from urdfkit.robot.model import Joint
from urdfkit.robot.tree import KinematicTree

#: Chains of more joints are no arms, and chains beyond so many are fingers of one hand.
MAX_JOINTS, MAX_CHAINS = 200, 50

#: Poses from which the search starts besides the zero pose, and its rounds at most.
STARTS, ROUNDS = 12, 200


class Reach(Record):
    """The chain with the longest reach."""

    distance: float  # from the first moving joint of the chain to the origin of its last link, in m
    joint: str  # that first joint
    link: str  # that last link
    pose: dict[str, float]  # the positions of the joints of the chain there, in rad or m


def reach(tree: KinematicTree) -> Reach | None:
    """The longest reach of all chains; None where nothing moves.

    Joints that follow others by ``<mimic>`` count as if they were free within their limits.
    """
    chains = [
        chain for chain in _chains(tree) if len(chain) <= MAX_JOINTS and isfinite(_span(chain))
    ]
    chains.sort(key=_span, reverse=True)
    best: Reach | None = None
    for chain in chains[:MAX_CHAINS]:
        if best is None or _span(chain) > best.distance:
            found = _reach(chain)
            if best is None or found.distance > best.distance:
                best = found
    return best


def _chains(tree: KinematicTree) -> list[list[Joint]]:
    """The chains from each moving joint that has none above it to the ends of the tree."""
    found: list[list[Joint]] = []
    for end, joints in tree.children.items():
        if joints:
            continue
        way: list[Joint] = []
        above = tree.parents[end]
        while above and len(way) <= MAX_JOINTS:
            way.append(above[0])
            above = tree.parents[above[0].parent_name]
        while way and not _moves(way[-1]):
            way.pop()
        if way:
            found.append(way[::-1])
    return found


def _moves(joint: Joint) -> bool:
    return joint.kind in TURNING or joint.kind in SLIDING


def _span(chain: list[Joint]) -> float:
    """What the chain cannot exceed: all its parts in one line."""
    travel = sum(max(map(abs, span(joint))) for joint in chain if joint.kind in SLIDING)
    return travel + sum(hypot(*joint.origin.position) for joint in chain[1:])


def _reach(chain: list[Joint]) -> Reach:
    """Climb from several poses, one joint at a time to its best position: each is a closed form."""
    ranges = [span(joint) for joint in chain]
    random = Random(0)
    starts = [[min(max(0.0, low), high) for low, high in ranges]]
    starts += [[random.uniform(*ends) for ends in ranges] for _ in range(STARTS)]
    tops = [_climb(chain, ranges, start) for start in starts]
    distance, pose = max(tops, key=lambda top: top[0])
    named = {joint.name: place for joint, place in zip(chain, pose, strict=True) if _moves(joint)}
    return Reach(distance, chain[0].name, chain[-1].child_name, named)


def _climb(
    chain: list[Joint], ranges: list[tuple[float, float]], pose: list[float]
) -> tuple[float, list[float]]:
    """Rounds over the joints until the distance grows no more."""
    pose, best = list(pose), -1.0
    for _ in range(ROUNDS):
        bases = _bases(chain, pose)
        tip: Vector = ORIGIN
        for index in range(len(chain) - 1, -1, -1):
            joint = chain[index]
            if _moves(joint):
                pose[index] = _best(joint, ranges[index], bases[index], tip, pose[index])
            tip = motion(joint, pose[index]).apply(tip)
            if index:
                tip = joint.origin.apply(tip)
        distance = hypot(*tip)
        if not distance > best * (1 + 1e-12):
            break
        best = distance
    return best, pose


def _bases(chain: list[Joint], pose: list[float]) -> list[Vector]:
    """The point of the first joint, in the frame of each joint at its zero."""
    bases: list[Vector] = [ORIGIN]
    for joint, position, following in zip(chain, pose, chain[1:], strict=False):
        inner = motion(joint, position).inverse.apply(bases[-1])
        bases.append(following.origin.inverse.apply(inner))
    return bases


def _best(joint: Joint, ends: tuple[float, float], base: Vector, tip: Vector, now: float) -> float:
    """The position at which a joint takes the tip farthest from the base.

    The squared distance is ``a - 2 (b cos q + c sin q)`` of an angle q (Rodrigues' formula), and
    of a slide a parabola that opens upwards.
    """
    axis = direction(joint)
    if joint.kind in SLIDING:
        along = dot(axis, minus(tip, base))
        return max(ends, key=lambda q: abs(q + along))
    b = dot(base, tip) - dot(axis, base) * dot(axis, tip)
    c = dot(base, cross(axis, tip))
    if b * b + c * c <= 1e-24 * dot(base, base) * dot(tip, tip):
        return now  # the turn changes nothing
    return best_angle(-b, -c, ends)

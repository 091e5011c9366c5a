"""Where the links are at a configuration, without numpy: a robot has a thousand of them.

Positions are in rad or m, by the name of the joint.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2, cos, isfinite, pi, sin

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, rotation_about, times, unit
from urdfkit.robot.model import Joint, Mimic, UnknownLink
from urdfkit.robot.tree import KinematicTree

#: The joints that one number moves.
TURNING, SLIDING = ("revolute", "continuous"), ("prismatic",)


class MimicLaw(Record):
    """What a joint follows: ``position = factor * position of the leader + shift``."""

    #: A joint that follows none; the joint itself where it follows none; empty for one that is
    #: locked, since it follows a joint that is not there, a ring, or by numbers that no linkage
    #: has.
    leader: str
    #: factor and shift: of all multipliers and offsets on the way to the leader.
    factor: float
    shift: float


#: In rad or m, and as a factor: no linkage moves a joint by so much.
_LARGEST = 1e9

#: Of a locked joint: one that is not set by one number, or follows itself.
LOCKED = MimicLaw("", 0.0, 0.0)
#: Of a leader that is not there.
_ABSENT = MimicLaw("", 0.0, 0.0)


def laws(joints: Mapping[str, Joint]) -> dict[str, MimicLaw]:
    """What each joint follows in the end, through any number of joints between.

    Args:
        joints: of a model, by name.
    """
    found: dict[str, MimicLaw] = {}
    for start in joints:
        name, chain = start, list[tuple[str, Mimic]]()
        while name in joints and name not in found:
            mimic = joints[name].mimic
            if mimic is None or mimic.joint is None:
                found[name] = MimicLaw(name, 1.0, 0.0)
                break
            found[name] = LOCKED  # unless the chain ends, and does not come back here
            chain.append((name, mimic))
            name = mimic.joint.value
        law = found.get(name, _ABSENT)
        for follower, mimic in reversed(chain):
            law = _followed(law, mimic)
            found[follower] = law
    return found


def _followed(law: MimicLaw, mimic: Mimic) -> MimicLaw:
    """What a joint follows, from what its leader follows."""
    factor, shift = mimic.multiplier * law.factor, mimic.multiplier * law.shift + mimic.offset
    is_linkage = abs(factor) < _LARGEST and abs(shift) < _LARGEST
    return MimicLaw(law.leader, factor, shift) if is_linkage and law is not LOCKED else LOCKED


def positions(tree: KinematicTree, given: Mapping[str, float]) -> dict[str, float]:
    """The position of every joint that one number moves.

    Args:
        given: positions of joints; the others are at 0. A joint that mimics another one follows
            it, whatever is given for it; in a ring of such joints all stay at 0.
    """
    joints = tree.model.joints_by_name
    followed = laws(joints)
    found: dict[str, float] = {}
    for name, joint in joints.items():
        if joint.kind in TURNING or joint.kind in SLIDING:
            leader, factor, shift = followed[name]
            position = factor * given.get(leader, 0.0) + shift
            found[name] = position if isfinite(position) else 0.0
    return found


def frames(tree: KinematicTree, given: Mapping[str, float]) -> dict[str, Transform]:
    """Where each link is, in the frame of its root link.

    Floating and planar joints stay at their origin; a link in a closed loop that no root leads
    to is nowhere.

    Args:
        tree: of the model.
        given: positions of joints, as for `positions`.
    """
    moved = positions(tree, given)
    if not any(moved.values()):
        return dict(tree.frames)
    found = {root.name: Transform() for root in tree.roots}
    for joint in tree.spanning:
        parent, position = found[joint.parent_name], moved.get(joint.name, 0.0)
        found[joint.child_name] = parent @ joint.origin @ motion(joint, position)
    return found


def transform(tree: KinematicTree, given: Mapping[str, float], link: str, seen: str) -> Transform:
    """Where a link is in the frame of another one.

    Args:
        tree: of the model.
        given: positions of joints, as for `positions`.
        link: name of the link.
        seen: name of the link that it is seen from.

    Raises:
        UnknownLink: there is no such link, or no joints between the two.
    """
    for name in (link, seen):
        tree.model.require_link(name)
    found = frames(tree, given)
    if link not in found or tree.root_of[link] != tree.root_of.get(seen):
        raise UnknownLink(f"links '{seen}' and '{link}' are not connected by joints")
    return found[seen].inverse @ found[link]


def motion(joint: Joint, position: float) -> Transform:
    """The frame of the child of a joint, in that of the joint at zero."""
    if position == 0:
        return Transform()
    axis = direction(joint)
    if joint.kind in SLIDING:
        return Transform(position=times(axis, position))
    if joint.kind in TURNING:
        return Transform(rotation_about(axis, position))
    return Transform()


def direction(joint: Joint) -> Vector:
    """The unit vector of the axis; x where none is written or it has no direction."""
    return unit(joint.axis.value) if joint.axis and any(joint.axis.value) else (1.0, 0.0, 0.0)


def best_angle(a: float, b: float, ends: tuple[float, float]) -> float:
    """The angle between two ends at which ``a cos q + b sin q`` is largest, the nearest to 0."""
    top = atan2(b, a)
    inside = [q for q in (top - 2 * pi, top, top + 2 * pi) if ends[0] <= q <= ends[1]]
    if inside:
        return min(inside, key=abs)
    return max(ends, key=lambda q: a * cos(q) + b * sin(q))

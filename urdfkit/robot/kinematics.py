"""Forward kinematics without numpy, whose import takes longer than a thousand links.

Configurations are joint positions in rad or m, by the name of the joint.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import atan2, cos, isfinite, pi, sin

from urdfkit.core.record import Record
from urdfkit.core.spatial import X_AXIS, Transform, Vector, rotation_about, times, unit
from urdfkit.robot.joint import Joint, Mimic
from urdfkit.robot.model import UnknownLink
from urdfkit.robot.tree import KinematicTree


class MimicLaw(Record):
    """Mimic relation of a joint: ``position = factor * position of the leader + shift``."""

    #: The independent joint at the end of the mimic chain; the joint itself if it mimics none;
    #: empty for a locked joint: its chain leads to a missing joint or a cycle, or its factor or
    #: shift is implausible.
    leader: str
    #: factor and shift: of the whole chain to the leader.
    factor: float
    shift: float


#: Larger shifts, in rad or m, and factors are implausible.
_MAX_COEFFICIENT = 1e9

#: Relation of a locked joint.
LOCKED = MimicLaw("", 0.0, 0.0)
#: Relation of a missing leader.
_ABSENT = MimicLaw("", 0.0, 0.0)


def laws(joints: Mapping[str, Joint]) -> dict[str, MimicLaw]:
    """The mimic relation of each joint to an independent joint, through any number of joints.

    Args:
        joints: of a model, by name.
    """
    relations: dict[str, MimicLaw] = {}
    for start in joints:
        name, chain = start, list[tuple[str, Mimic]]()
        while name in joints and name not in relations:
            mimic = joints[name].mimic
            if mimic is None or mimic.joint is None:
                relations[name] = MimicLaw(name, 1.0, 0.0)
                break
            relations[name] = LOCKED  # replaced below unless the chain is a cycle
            chain.append((name, mimic))
            name = mimic.joint.value
        law = relations.get(name, _ABSENT)
        for follower, mimic in reversed(chain):
            law = _followed(law, mimic)
            relations[follower] = law
    return relations


def _followed(law: MimicLaw, mimic: Mimic) -> MimicLaw:
    """The relation of a mimic joint, from the relation of its leader."""
    factor, shift = mimic.multiplier * law.factor, mimic.multiplier * law.shift + mimic.offset
    is_linkage = abs(factor) < _MAX_COEFFICIENT and abs(shift) < _MAX_COEFFICIENT
    return MimicLaw(law.leader, factor, shift) if is_linkage and law is not LOCKED else LOCKED


def positions(tree: KinematicTree, given: Mapping[str, float]) -> dict[str, float]:
    """The positions of all joints with one coordinate.

    Args:
        given: positions of joints; the others are at 0. Values for mimic joints are ignored: they
            follow their leaders, and stay at 0 in a cycle.
    """
    joints = tree.model.joints_by_name
    relations = laws(joints)
    values: dict[str, float] = {}
    for name, joint in joints.items():
        if joint.is_single_dof:
            leader, factor, shift = relations[name]
            position = factor * given.get(leader, 0.0) + shift
            values[name] = position if isfinite(position) else 0.0
    return values


def frames(tree: KinematicTree, given: Mapping[str, float]) -> dict[str, Transform]:
    """The frame of each link, in the frame of its root link.

    Floating and planar joints stay at their origin; links in a closed loop without a root are
    omitted.

    Args:
        tree: of the model.
        given: positions of joints, as for `positions`.
    """
    moved = positions(tree, given)
    if not any(moved.values()):
        return dict(tree.frames)
    placed = {root.name: Transform() for root in tree.roots}
    for joint in tree.spanning:
        parent, position = placed[joint.parent_name], moved.get(joint.name, 0.0)
        placed[joint.child_name] = parent @ joint.origin @ motion(joint, position)
    return placed


def transform(tree: KinematicTree, given: Mapping[str, float], link: str, seen: str) -> Transform:
    """The frame of a link in the frame of a reference link.

    Args:
        tree: of the model.
        given: positions of joints, as for `positions`.
        link: name of the link.
        seen: name of the reference link.

    Raises:
        UnknownLink: a link does not exist, or no joints connect the two.
    """
    for name in (link, seen):
        tree.model.require_link(name)
    placed = frames(tree, given)
    if link not in placed or tree.root_of[link] != tree.root_of.get(seen):
        raise UnknownLink(f"links '{seen}' and '{link}' are not connected by joints")
    return placed[seen].inverse @ placed[link]


def motion(joint: Joint, position: float) -> Transform:
    """The frame of the child of a joint, in the joint frame."""
    if position == 0:
        return Transform()
    axis = direction(joint)
    if joint.is_prismatic:
        return Transform(position=times(axis, position))
    if joint.is_rotational:
        return Transform(rotation_about(axis, position))
    return Transform()


def direction(joint: Joint) -> Vector:
    """The unit vector of the axis; x if it is missing or zero."""
    return unit(joint.axis.value) if joint.axis and any(joint.axis.value) else X_AXIS


def best_angle(a: float, b: float, ends: tuple[float, float]) -> float:
    """The angle between two limits that maximises ``a cos q + b sin q``; the one nearest to 0."""
    best = atan2(b, a)
    candidates = [q for q in (best - 2 * pi, best, best + 2 * pi) if ends[0] <= q <= ends[1]]
    if candidates:
        return min(candidates, key=abs)
    return max(ends, key=lambda q: a * cos(q) + b * sin(q))

"""Where the links are at a configuration, without numpy: a robot has a thousand of them.

Positions are in rad or m, by the name of the joint.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import cos, sin

from urdfkit.model import Joint, length
from urdfkit.spatial import Frame, Rotation, Vector
from urdfkit.tree import KinematicTree

#: The joints that one number moves.
TURNING, SLIDING = ("revolute", "continuous"), ("prismatic",)


def positions(tree: KinematicTree, given: Mapping[str, float]) -> dict[str, float]:
    """The position of every joint that one number moves.

    Args:
        tree: of the model.
        given: positions of joints; the others are at 0. A joint that mimics another one follows
            it, whatever is given for it; in a ring of such joints all stay at 0.
    """
    joints = tree.model.joints_by_name
    found: dict[str, float] = {}
    for name, joint in joints.items():
        if joint.kind in TURNING or joint.kind in SLIDING:
            found[name] = _position(joint, joints, given)
    return found


def _position(joint: Joint, joints: Mapping[str, Joint], given: Mapping[str, float]) -> float:
    factor, shift, seen = 1.0, 0.0, {joint.name}
    while joint.mimic and joint.mimic.joint:
        shift += factor * joint.mimic.offset
        factor *= joint.mimic.multiplier
        leader = joints.get(joint.mimic.joint.value)
        if leader is None:
            return shift
        if leader.name in seen:
            return 0.0
        seen.add(leader.name)
        joint = leader
    return factor * given.get(joint.name, 0.0) + shift


def frames(tree: KinematicTree, given: Mapping[str, float]) -> dict[str, Frame]:
    """Where each link is, in the frame of its root link.

    Floating and planar joints stay at their origin; a link in a closed loop that no root leads
    to is nowhere.

    Args:
        tree: of the model.
        given: positions of joints, as for `positions`.
    """
    moved = positions(tree, given)
    found: dict[str, Frame] = {}
    for root in tree.roots:
        found[root.name] = Frame()
        queue = [root.name]
        while queue:
            parent = queue.pop()
            for joint in tree.children[parent]:
                assert joint.child is not None
                child = joint.child.value
                if child not in found:
                    found[child] = (
                        found[parent] @ joint.origin @ motion(joint, moved.get(joint.name, 0.0))
                    )
                    queue.append(child)
    return found


def motion(joint: Joint, position: float) -> Frame:
    """The frame of the child of a joint, in that of the joint at zero."""
    if position == 0:
        return Frame()
    axis = direction(joint)
    if joint.kind in SLIDING:
        return Frame(position=(axis[0] * position, axis[1] * position, axis[2] * position))
    if joint.kind in TURNING:
        return Frame(about(axis, position))
    return Frame()


def direction(joint: Joint) -> Vector:
    """The unit vector of the axis; x where none is written or it has no direction."""
    x, y, z = joint.axis.value if joint.axis else (1.0, 0.0, 0.0)
    norm = length((x, y, z))
    return (x / norm, y / norm, z / norm) if norm > 0 else (1.0, 0.0, 0.0)


def about(axis: Vector, angle: float) -> Rotation:
    """Rotation about a unit vector (Rodrigues' formula)."""
    x, y, z = axis
    c, s = cos(angle), sin(angle)
    t = 1 - c
    return (
        (t * x * x + c, t * x * y - s * z, t * x * z + s * y),
        (t * x * y + s * z, t * y * y + c, t * y * z - s * x),
        (t * x * z - s * y, t * y * z + s * x, t * z * z + c),
    )

"""Fingers that bend the other way than the others, in one joint or as a whole."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.checks.joints.fingers import OddJoint
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector, dot, rotate, times
from urdfkit.core.words import listed
from urdfkit.lint.context import Context
from urdfkit.robot.fingers import finger_of, odd_one
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction

#: Part of a range on the other side of zero up to which a joint bends to one side.
_OTHER_SIDE = 0.1

#: Cosine of the angle between two axes above which they are parallel.
_PARALLEL = 0.99

#: Least number of joints of a finger, of which one may bend the other way.
_MIN_JOINTS = 3

#: Least number of fingers whose joints all bend one way next to one with another joint.
_MIN_CONSISTENT = 2


class _Bend(Record):
    """A joint and the axis in the root frame about which it bends from zero."""

    joint: Joint
    axis: Vector


def bending_fingers(context: Context) -> Iterator[OddJoint]:
    fingers = _fingers(context)
    straight = [finger for finger in fingers if _odd_joint(finger) is None]
    odd = [found for finger in fingers if (found := _odd_joint(finger))]
    if len(odd) == 1 and len(straight) >= _MIN_CONSISTENT:
        ((bend, other),) = odd
        difference = f"bends the other way than the other joints of its finger, '{other.name}'; "
        difference += f"all joints of {len(straight)} other fingers bend one way"
        at = bend.joint.at.child_or_self("axis")
        yield OddJoint(bend.joint, at, difference, "invert its <axis>", other)
    if not odd:
        yield from _turned_fingers(straight)


def _fingers(context: Context) -> list[list[_Bend]]:
    """The chains of joints that bend to one side about parallel axes."""
    bends = list(_bends(context))
    above = {bend.joint.child_name: bend for bend in bends}
    below = by_key((bend.joint.parent_name, bend) for bend in bends)
    fingers = []
    for bend in bends:
        if (before := above.get(bend.joint.parent_name)) and _are_parallel(before, bend):
            continue
        finger, links = [bend], {bend.joint.parent_name}
        while len(following := below.get(finger[-1].joint.child_name, [])) == 1:
            (after,) = following
            if after.joint.parent_name in links or not _are_parallel(bend, after):
                break
            finger.append(after)
            links.add(after.joint.parent_name)
        if len(finger) >= _MIN_JOINTS:
            fingers.append(finger)
    return fingers


def _are_parallel(one: _Bend, other: _Bend) -> bool:
    return abs(dot(one.axis, other.axis)) > _PARALLEL


def _bends(context: Context) -> Iterator[_Bend]:
    for joint in context.model.joints:
        frame, ends = context.tree.frames.get(joint.child_name), bounds(joint)
        if not joint.is_rotational or frame is None or ends is None or ends[0] >= ends[1]:
            continue  # JNT003
        small, large = sorted(ends, key=abs)
        if abs(small) <= _OTHER_SIDE * abs(large):
            side = 1.0 if large > 0 else -1.0
            yield _Bend(joint, times(rotate(frame.rotation, direction(joint)), side))


def _odd_joint(finger: list[_Bend]) -> tuple[_Bend, Joint] | None:
    """The only joint that bends the other way than the others of its finger, and one of these."""
    first = finger[0].axis
    groups = by_key((dot(bend.axis, first) > 0, bend) for bend in finger)
    if len(groups) == 1:
        return None
    few, many = sorted(groups.values(), key=len)
    return (few[0], many[0].joint) if len(few) == 1 < len(many) else None


def _turned_fingers(fingers: list[list[_Bend]]) -> Iterator[OddJoint]:
    """The finger that bends the other way than the three others of its hand."""
    named = [(_hand_and_finger(finger), finger) for finger in fingers]
    hands = by_key((hand, (word, finger)) for (hand, word), finger in named if word)
    for hand in hands.values():
        bends = {word: finger[0] for word, finger in hand}
        first = next(iter(bends.values())).axis
        cosines = {word: dot(bend.axis, first) for word, bend in bends.items()}
        odd = odd_one({word: cosine > 0 for word, cosine in cosines.items()})
        if odd and all(abs(cosine) > _PARALLEL for cosine in cosines.values()):
            joint = bends[odd[0]].joint
            others = [bend.joint for word, bend in bends.items() if word != odd[0]]
            names = listed([f"'{other.name}'" for other in others])
            difference = f"bends its finger the other way than {names}"
            at = joint.at.child_or_self("origin")
            help = "correct the rpy of its <origin>, or invert the <axis> of all its joints"
            yield OddJoint(joint, at, difference, help, others[0])


def _hand_and_finger(finger: list[_Bend]) -> tuple[str, str]:
    """The text before the word for the finger, which names the hand, and the word."""
    for bend in finger:
        if word := finger_of(bend.joint.name):
            return bend.joint.name.partition(word)[0].lower(), word.lower()
    return "", ""

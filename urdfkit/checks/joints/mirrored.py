"""Joints that are not at the mirror image of their left or right counterpart."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.spatial import Rotation, Vector, dot, minus
from urdfkit.core.words import spaced
from urdfkit.lint.context import Context
from urdfkit.robot.joint import Joint
from urdfkit.robot.model import RobotModel
from urdfkit.robot.symmetry import have_same_meshes, pairs

#: In m: tolerance for rounding.
_TOLERANCE = 1e-4
_AXES = "xyz"

#: In m: tolerance, as robots are not quite symmetric.
_ASYMMETRY = 0.004

#: Cosine of the angle below which two axes are different, not rounded.
_MAX_COSINE = 0.5

#: Least number of symmetric pairs next to one that is not symmetric.
_SYMMETRIC_PAIRS = 2


class _Pair(Record):
    """Movable counterparts, and the offset of the second from the first's mirror image.

    The second is the right joint, unless the left joint is misplaced.
    """

    left: Joint
    right: Joint
    off: Vector

    @property
    def distance(self) -> float:
        return max(map(abs, self.off))


def misplaced(context: Context) -> Iterator[tuple[Joint, Joint, str]]:
    """Counterparts that are not mirror images: correct joint, misplaced joint, and the reason."""
    reported = set()
    for correct, wrong, reason in _on_one_link(context.model):
        reported |= {correct.name, wrong.name}
        places = f"{_at(wrong)} {reason} its counterpart '{correct.name}' {_at(correct)}"
        yield correct, wrong, places
    for left, right, _ in on_the_other_side(context):
        reported |= {left.name, right.name}
    joints = by_key((joint.parent_name, joint) for joint in context.model.joints)
    for pair in _asymmetric(list(_pairs(context)), context, joints):
        if pair.right.name in reported:
            continue
        if _is_left_misplaced(context.model, pair.left, pair.right):
            x, y, z = pair.off
            swapped = _Pair(pair.right, pair.left, (-x, y, -z))
            yield swapped.left, swapped.right, _shift(swapped)
        else:
            yield pair.left, pair.right, _shift(pair)


def _on_one_link(model: RobotModel) -> Iterator[tuple[Joint, Joint, str]]:
    """Counterparts on one link of which one has a wrong sign in its position."""
    joints = {joint.name: joint for joint in model.joints if joint.name}
    siblings = [
        (first, second)
        for left, right in pairs(joints)
        if (first := joints[left]).parent_name == (second := joints[right]).parent_name
        and first.parent_name
        and first.kind == second.kind
    ]
    rotations = {_rotations(*pair) for pair in siblings if _is_mirrored_in_y(*pair)}
    for first, second in siblings:
        is_alike = first.origin.rotation == second.origin.rotation
        if not is_alike and _rotations(first, second) not in rotations:
            continue
        if reason := _reason(first, second):
            yield (
                (second, first, reason)
                if _is_left_misplaced(model, first, second)
                else (first, second, reason)
            )


def on_the_other_side(context: Context) -> Iterator[tuple[Joint, Joint, str]]:
    """Counterparts with chains of joints that both begin on the left, and the link on the right."""
    counterparts = context.symmetric_joints
    right_of = {left.child_name: right.child_name for left, right in counterparts}
    parents = {joint.parent_name for joint in context.model.joints}
    continued = {joint.parent_name for pair in counterparts for joint in pair}
    for left, right in counterparts:
        link = right_of.get(left.parent_name, "")
        is_leaf = link and link not in parents
        if is_leaf and left.parent_name == right.parent_name and right.child_name in continued:
            yield left, right, link


def _is_left_misplaced(model: RobotModel, left: Joint, right: Joint) -> bool:
    """True if the left counterpart is misplaced, judged by the other joints on their link."""
    others = [
        joint
        for joint in model.joints
        if joint.kind == left.kind
        and joint.parent_name == left.parent_name
        and joint.name not in (left.name, right.name)
    ]
    first, second = left.origin.position, right.origin.position
    places = [joint.origin.position for joint in others]
    if difference := _count_mirrored(second, places) - _count_mirrored(first, places):
        return difference > 0
    if not _is_equal(first, second):
        return any(_is_equal(first, place) for place in places)
    joints = {joint.name: joint.origin.position for joint in others if joint.name}
    sides = [joints[a][1] for a, b in pairs(joints) if joints[a][1] * joints[b][1] < 0]
    is_left_positive = sum(1 if y > 0 else -1 for y in sides) >= 0
    return (first[1] > 0) != is_left_positive


def _count_mirrored(place: Vector, places: list[Vector]) -> int:
    """Number of places at the same height and the same distance from the centre in x."""
    x, _, z = place
    return sum(abs(abs(a) - abs(x)) < _TOLERANCE and abs(c - z) < _TOLERANCE for a, _, c in places)


def _is_equal(one: Vector, other: Vector) -> bool:
    return all(abs(a - b) < _TOLERANCE for a, b in zip(one, other, strict=True))


def _pairs(context: Context) -> Iterator[_Pair]:
    frames = context.tree.frames
    for left, right in context.symmetric_joints:
        left_frame, right_frame = (frames.get(joint.child_name) for joint in (left, right))
        if left_frame and right_frame:
            (x, y, z), (a, b, c) = left_frame.position, right_frame.position
            if abs(y - b) > _ASYMMETRY:
                yield _Pair(left, right, (a - x, b + y, c - z))


def _asymmetric(
    counterparts: list[_Pair], context: Context, joints: Mapping[str, list[Joint]]
) -> list[_Pair]:
    """The pairs that are not mirror images although their parents are."""
    known = {pair.right.child_name: pair.distance for pair in counterparts}
    odd, inherited = [], 0
    for pair in counterparts:
        is_shared = pair.left.parent_name == pair.right.parent_name
        above = 0.0 if is_shared else known.get(pair.right.parent_name, 0.0)
        if above > _TOLERANCE:
            inherited += 1
        elif pair.distance > _ASYMMETRY:
            odd.append(pair)
    exact = sum(pair.distance <= _TOLERANCE for pair in counterparts)
    if len(odd) == 1 and exact >= _SYMMETRIC_PAIRS and exact + inherited + 1 == len(counterparts):
        x, _, z = odd[0].off
        if max(abs(x), abs(z)) > _ASYMMETRY and not _is_turned_copy(odd[0], context):
            return odd  # else the plane of symmetry may be another one
    return [
        pair
        for pair in odd
        if _is_shifted_along_one_axis(pair) or (exact and _has_copied_offset(pair, context, joints))
    ]


def _has_copied_offset(pair: _Pair, context: Context, joints: Mapping[str, list[Joint]]) -> bool:
    """True for counterparts on mirrored links, to the same side of them."""
    left, right = pair.left, pair.right
    frames, links = context.tree.frames, context.model.links_by_name
    if have_same_meshes(links.get(left.parent_name), links.get(right.parent_name)):
        return False
    left_parent, right_parent = frames.get(left.parent_name), frames.get(right.parent_name)
    if left_parent is None or right_parent is None or left.parent_name == right.parent_name:
        return False
    is_followed = any(joint.is_single_dof for joint in joints.get(right.child_name, ()))
    if right.kind != "continuous" and not is_followed:
        return False  # both hands may have the same gripper
    place, right_place = frames[left.child_name].position, frames[right.child_name].position
    offset = minus(place, left_parent.position)
    is_copied = _is_equal(offset, minus(right_place, right_parent.position))
    are_mirrored = _is_equal(_mirror_image(left_parent.position), right_parent.position)
    if not (are_mirrored and is_copied and abs(offset[1]) > _ASYMMETRY):
        return False
    siblings = (frames.get(joint.child_name) for joint in joints.get(right.parent_name, ()))
    # Another link has the place of the mirror image: only the names are not mirrored.
    image = _mirror_image(place)
    return not any(frame and _is_equal(frame.position, image) for frame in siblings)


def _is_turned_copy(pair: _Pair, context: Context) -> bool:
    """True for the same origin in frames that are turned: both arms are the same product."""
    left, right = pair.left, pair.right
    frames = [context.tree.frames.get(joint.parent_name) for joint in (left, right)]
    if None in frames or left.origin.rotation != right.origin.rotation:
        return False
    first, second = (frame.rotation for frame in frames if frame)
    is_turned = any(dot(a, b) < _MAX_COSINE for a, b in zip(first, second, strict=True))
    return is_turned and _is_equal(left.origin.position, right.origin.position)


def _mirror_image(place: Vector) -> Vector:
    x, y, z = place
    return (x, -y, z)


def _is_shifted_along_one_axis(pair: _Pair) -> bool:
    """True for counterparts on one link that differ in x alone, or in z."""
    left, right = pair.left, pair.right
    if left.origin.rotation != right.origin.rotation or left.parent_name != right.parent_name:
        return False
    is_equal = [abs(part) <= _TOLERANCE for part in pair.off]
    return is_equal[1] and sum(is_equal) == 2


def _shift(pair: _Pair) -> str:
    """Such as ``is 0.03 m forward of the mirror image of 'left_hip'``."""
    x, y, z = pair.off
    directions = ((x, "forward", "backward"), (y, "to the left", "to the right"), (z, "up", "down"))
    shifts = [
        f"{abs(part):.2g} m {plus if part > 0 else minus}"
        for part, plus, minus in directions
        if abs(part) > _TOLERANCE
    ]
    return f"is {' and '.join(shifts)} of the mirror image of '{pair.left.name}'"


def _reason(left: Joint, right: Joint) -> str:
    """The defect of two positions that should be mirror images; empty if there is none."""
    first, second = left.origin.position, right.origin.position
    equal = [abs(a - b) < _TOLERANCE for a, b in zip(first, second, strict=True)]
    flipped = [abs(a + b) < _TOLERANCE <= abs(a) for a, b in zip(first, second, strict=True)]
    if all(equal):
        return (
            "is at the same place as"
            if abs(first[1]) >= _TOLERANCE and _axis(left) == _axis(right)
            else ""
        )
    if not all(e or f for e, f in zip(equal, flipped, strict=True)) or not flipped[1]:
        return ""
    others = [axis for axis, turned in zip(_AXES, flipped, strict=True) if turned and axis != "y"]
    return f"is mirrored in y and also in {others[0]} from" if len(others) == 1 else ""


def _rotations(left: Joint, right: Joint) -> tuple[str, Rotation, Rotation]:
    return left.parent_name, left.origin.rotation, right.origin.rotation


def _is_mirrored_in_y(left: Joint, right: Joint) -> bool:
    place = left.origin.position
    is_aside = abs(place[1]) >= _TOLERANCE
    return is_aside and _is_equal(_mirror_image(place), right.origin.position)


def _axis(joint: Joint) -> Vector | None:
    return joint.axis.value if joint.axis else None


def _at(joint: Joint) -> str:
    return "at " + spaced(joint.origin.position, 4) + " m"

"""Joints that are not at the mirror image of their left or right counterpart."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.core.words import spaced
from urdfkit.lint.context import Context
from urdfkit.robot.model import Joint, RobotModel
from urdfkit.robot.symmetry import pairs

#: In m: tolerance for rounding.
_TOLERANCE = 1e-4
_AXES = "xyz"

#: In m: tolerance, as robots are not quite symmetric.
_ASYMMETRY = 0.004

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
    for pair in _asymmetric(list(_pairs(context))):
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
    for left, right in pairs(joints):
        first, second = joints[left], joints[right]
        if not first.parent_name or first.parent_name != second.parent_name:
            continue
        if first.kind == second.kind and (reason := _reason(first, second)):
            yield (
                (second, first, reason)
                if _is_left_misplaced(model, first, second)
                else (first, second, reason)
            )


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
        here, there = (frames.get(joint.child_name) for joint in (left, right))
        if here and there and abs(here.position[1] - there.position[1]) > _ASYMMETRY:
            (x, y, z), (a, b, c) = here.position, there.position
            yield _Pair(left, right, (a - x, b + y, c - z))


def _asymmetric(counterparts: list[_Pair]) -> list[_Pair]:
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
        return odd if max(abs(x), abs(z)) > _ASYMMETRY else []  # the plane of symmetry is unknown
    return [pair for pair in odd if _is_shifted_along_one_axis(pair)]


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


def _reason(one: Joint, other: Joint) -> str:
    """The defect of two positions that should be mirror images; empty if there is none."""
    if one.origin.rotation != other.origin.rotation:
        return ""
    first, second = one.origin.position, other.origin.position
    equal = [abs(a - b) < _TOLERANCE for a, b in zip(first, second, strict=True)]
    flipped = [abs(a + b) < _TOLERANCE <= abs(a) for a, b in zip(first, second, strict=True)]
    if all(equal):
        return (
            "is at the same place as"
            if abs(first[1]) >= _TOLERANCE and _axis(one) == _axis(other)
            else ""
        )
    if not all(e or f for e, f in zip(equal, flipped, strict=True)) or not flipped[1]:
        return ""
    others = [axis for axis, turned in zip(_AXES, flipped, strict=True) if turned and axis != "y"]
    return f"is mirrored in y and also in {others[0]} from" if len(others) == 1 else ""


def _axis(joint: Joint) -> Vector | None:
    return joint.axis.value if joint.axis else None


def _at(joint: Joint) -> str:
    return "at " + spaced(joint.origin.position, 4) + " m"

"""Left and right joints on one link of which one has a wrong sign in its position."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.spatial import Vector, minus
from urdfkit.robot.joint import Joint
from urdfkit.robot.model import RobotModel
from urdfkit.robot.symmetry import pairs

#: In m: tolerance for rounding.
TOLERANCE = 1e-4
_AXES = "xyz"
#: Parts of the names of casters.
_CASTERS = ("caster", "castor")


def misplaced_siblings(model: RobotModel) -> Iterator[tuple[Joint, Joint, str]]:
    """Counterparts on one link of which one has a wrong sign in its position."""
    joints = {joint.name: joint for joint in model.joints if joint.name}
    siblings = [
        (first, second)
        for left, right in pairs(joints)
        if (first := joints[left]).parent_name == (second := joints[right]).parent_name
        and first.parent_name
        and first.kind == second.kind
    ]
    mirrored = [pair for pair in siblings if _is_mirrored_in_y(*pair)]
    for first, second in siblings:
        is_alike = is_equally_turned(first, second)
        if not is_alike and not any(_are_turned_like(pair, (first, second)) for pair in mirrored):
            continue
        reason = _wrong_position(first, second)
        if reason and not _have_mirrored_siblings(model, first, second):
            is_left = is_left_misplaced(model, first, second)
            yield (second, first, reason) if is_left else (first, second, reason)
    for first, second in siblings:
        if first.kind == "fixed" and (corner := _odd_corner(first, second, mirrored)):
            yield corner


def _odd_corner(
    left: Joint, right: Joint, mirrored: list[tuple[Joint, Joint]]
) -> tuple[Joint, Joint, str] | None:
    """The one of four corners, such as casters, that differs from the other three in x or z.

    The corners are around the origin, or it is at the place of another one.
    """
    (x, y, z), (a, b, c) = left.origin.position, right.origin.position
    is_moved = (abs(abs(x) - abs(a)) >= TOLERANCE) != (abs(z - c) >= TOLERANCE)
    if abs(y) < TOLERANCE or abs(y + b) >= TOLERANCE or not is_moved:
        return None
    others = [
        joint for pair in mirrored if pair[0].parent_name == left.parent_name for joint in pair
    ]
    places = [joint.origin.position for joint in others]
    for correct, wrong in ((left, right), (right, left)):
        x, y, z = correct.origin.position
        is_corner = abs(x) >= TOLERANCE and any(is_equal(place, (-x, y, z)) for place in places)
        is_moved_corner = any(is_equal(place, wrong.origin.position) for place in places)
        if is_corner or is_moved_corner or _is_raised_caster(correct, wrong):
            forward, _, up = minus(wrong.origin.position, correct.origin.position)
            if abs(up) >= TOLERANCE:
                return correct, wrong, f"is {'higher' if up > 0 else 'lower'} than"
            return correct, wrong, f"is further {'forward' if forward > 0 else 'back'} than"
    return None


def _is_raised_caster(correct: Joint, wrong: Joint) -> bool:
    """True for two casters at the same place of both sides, of which one is higher."""
    is_caster = all(
        any(word in f"{joint.name} {joint.child_name}".lower() for word in _CASTERS)
        for joint in (correct, wrong)
    )
    up = wrong.origin.position[2] - correct.origin.position[2]
    return is_caster and up >= TOLERANCE


def _wrong_position(left: Joint, right: Joint) -> str:
    """The defect of two positions that should be mirror images; empty if there is none."""
    first, second = left.origin.position, right.origin.position
    equal = [abs(a - b) < TOLERANCE for a, b in zip(first, second, strict=True)]
    flipped = [abs(a + b) < TOLERANCE <= abs(a) for a, b in zip(first, second, strict=True)]
    if all(equal):
        is_copied = abs(first[1]) >= TOLERANCE and _axis(left) == _axis(right)
        return "is at the same place as" if is_copied else ""
    if not all(e or f for e, f in zip(equal, flipped, strict=True)) or not flipped[1]:
        return ""
    others = [axis for axis, turned in zip(_AXES, flipped, strict=True) if turned and axis != "y"]
    return f"is mirrored in y and also in {others[0]} from" if len(others) == 1 else ""


def _have_mirrored_siblings(model: RobotModel, left: Joint, right: Joint) -> bool:
    """True if other joints are where the mirror images are: only the names are not mirrored."""
    places = [
        joint.origin.position
        for joint in model.joints
        if joint.parent_name == left.parent_name and joint.kind == left.kind
    ]
    first, second = left.origin.position, right.origin.position
    images = [mirror_image(first), mirror_image(second)]
    return not is_equal(first, second) and all(
        any(is_equal(image, place) for place in places) for image in images
    )


def _are_turned_like(one: tuple[Joint, Joint], other: tuple[Joint, Joint]) -> bool:
    return one[0].parent_name == other[0].parent_name and all(
        is_equally_turned(a, b) for a, b in zip(one, other, strict=True)
    )


def is_equally_turned(one: Joint, other: Joint) -> bool:
    """True for origins with the same rotation; exporters write it with rounding errors."""
    return all(map(is_equal, one.origin.rotation, other.origin.rotation))


def _is_mirrored_in_y(left: Joint, right: Joint) -> bool:
    place = left.origin.position
    is_aside = abs(place[1]) >= TOLERANCE
    return is_aside and is_equal(mirror_image(place), right.origin.position)


def _axis(joint: Joint) -> Vector | None:
    return joint.axis.value if joint.axis else None


def is_left_misplaced(model: RobotModel, left: Joint, right: Joint) -> bool:
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
    if difference := _count_counterparts(second, places) - _count_counterparts(first, places):
        return difference > 0
    if not is_equal(first, second):
        return any(is_equal(first, place) for place in places)
    joints = {joint.name: joint.origin.position for joint in others if joint.name}
    sides = [joints[a][1] for a, b in pairs(joints) if joints[a][1] * joints[b][1] < 0]
    is_left_positive = sum(1 if y > 0 else -1 for y in sides) >= 0
    return (first[1] > 0) != is_left_positive


def _count_counterparts(place: Vector, places: list[Vector]) -> int:
    """Number of places at the same height and the same distance from the centre in x."""
    x, _, z = place
    return sum(abs(abs(a) - abs(x)) < TOLERANCE and abs(c - z) < TOLERANCE for a, _, c in places)


def mirror_image(place: Vector) -> Vector:
    x, y, z = place
    return (x, -y, z)


def is_equal(one: Vector, other: Vector) -> bool:
    return all(abs(a - b) < TOLERANCE for a, b in zip(one, other, strict=True))

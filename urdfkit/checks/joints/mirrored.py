"""Joints that are not at the mirror image of their left or right counterpart."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import dist

from urdfkit.checks.joints.mirrored_siblings import (
    TOLERANCE,
    is_equal,
    is_equally_turned,
    is_left_misplaced,
    mirror_image,
    misplaced_siblings,
)
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector, dot, minus, vector
from urdfkit.core.words import spaced
from urdfkit.lint.context import Context
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction
from urdfkit.robot.link import Link
from urdfkit.robot.shapes import solid
from urdfkit.robot.symmetry import are_copies, has_one_side, on_separate_branches, pairs
from urdfkit.robot.tree import KinematicTree

#: In m: tolerance, as robots are not quite symmetric.
_ASYMMETRY = 0.004

#: Least ratio of the distance of a misplaced pair to that of any symmetric one.
_MIN_RATIO = 10.0

#: Cosine of the angle below which two axes are different, not rounded.
_MAX_COSINE = 0.5

#: Least number of symmetric pairs next to one that is not symmetric.
_SYMMETRIC_PAIRS = 2

#: Least number of exact pairs next to one that differs in one number, by this distance in m.
_EXACT_PAIRS, _OTHER_NUMBER = 4, 1e-3


class _Pair(Record):
    """Movable counterparts, and the offset of the second from the first's mirror image.

    The second is the right joint, unless the left joint is misplaced.
    """

    left: Joint
    right: Joint
    offset: Vector  # in m

    @property
    def distance(self) -> float:
        return max(map(abs, self.offset))


def misplaced(context: Context) -> Iterator[tuple[Joint, Joint, str]]:
    """Counterparts that are not mirror images: correct joint, misplaced joint, and the reason.

    First those on one link, whose positions alone tell it, then those whose frames in the robot
    differ although the frames of their parents do not.
    """
    reported: set[str] = set()
    for correct, wrong, reason in misplaced_siblings(context.model):
        reported |= _moved_with(correct, context) | _moved_with(wrong, context)
        if _would_overlap(context, correct, wrong) or _are_mirrored_bodies(context, correct, wrong):
            continue
        places = f"{_at(wrong)} {reason} its counterpart '{correct.name}' {_at(correct)}"
        yield correct, wrong, places
    for correct, wrong, *_ in on_the_other_side(context):
        reported |= {correct.name, wrong.name}
    for correct, wrong, _ in on_another_branch(context):
        reported |= {correct.name, wrong.name}
    joints = by_key((joint.parent_name, joint) for joint in context.model.joints)
    movable = list(_pairs(context, context.symmetric_joints))
    fixed = list(_pairs(context, _fixed_joints(context, movable)))
    asymmetric = _asymmetric(movable, movable, context, joints)
    others = [*movable, *fixed]
    for pair in (*asymmetric, *_asymmetric(fixed, movable, context, joints)):
        if pair.right.name in reported:
            continue
        if is_left_misplaced(context.model, pair.left, pair.right) or _is_left_alone(pair, others):
            x, y, z = pair.offset
            swapped = _Pair(pair.right, pair.left, (-x, y, -z))
            yield swapped.left, swapped.right, _shift(swapped)
        else:
            yield pair.left, pair.right, _shift(pair)


def _moved_with(joint: Joint, context: Context) -> set[str]:
    """The names of a joint and of those below it."""
    below = set(context.tree.below(joint.child_name))
    return {joint.name, *(one.name for one in context.model.joints if one.parent_name in below)}


def _is_left_alone(pair: _Pair, counterparts: list[_Pair]) -> bool:
    """True if another pair has the origin of the right joint, and none that of the left one."""
    others = [
        joint for other in counterparts if other != pair for joint in (other.left, other.right)
    ]
    left, right = (
        any(_size(joint) == _size(other) for other in others) for joint in (pair.left, pair.right)
    )
    return right and not left


def _size(joint: Joint) -> Vector:
    """The coordinates of the origin without their signs."""
    return vector(round(abs(part), 4) for part in joint.origin.position)


def _would_overlap(context: Context, correct: Joint, wrong: Joint) -> bool:
    """True for fixed parts that are too wide to be side by side, such as two boards."""
    link = context.model.links_by_name.get(wrong.child_name)
    if wrong.kind != "fixed" or link is None or is_equal(*_places(correct, wrong)):
        return False
    body = solid(link.visuals, context.mesh_solid)
    if body is None:
        return False
    place = correct.origin.position
    mirrored = correct.origin._replace(position=mirror_image(place))
    return body.bounds.moved(correct.origin).gap(body.bounds.moved(mirrored)) <= 0


def _are_mirrored_bodies(context: Context, correct: Joint, wrong: Joint) -> bool:
    """True for bodies at mirrored places, such as a bracket that is turned inside its link."""
    boxes = []
    for joint in (correct, wrong):
        link = context.model.links_by_name.get(joint.child_name)
        body = solid(link.visuals, context.mesh_solid) if link else None
        if body is None:
            return False
        boxes.append(body.bounds.moved(joint.origin))
    (low, high), (other_low, other_high) = boxes
    image = mirror_image((low[0], high[1], low[2])), mirror_image((high[0], low[1], high[2]))
    return max(map(dist, image, (other_low, other_high))) < _ASYMMETRY


def _places(one: Joint, other: Joint) -> tuple[Vector, Vector]:
    return one.origin.position, other.origin.position


def on_the_other_side(context: Context) -> Iterator[tuple[Joint, Joint, str, str]]:
    """Counterparts on one side: correct and wrong joint, its parent, which is a leaf, and why.

    Fingers of one hand are side by side, or end chains there.
    """
    counterparts = context.symmetric_joints
    right_of = {left.child_name: right.child_name for left, right in counterparts}
    left_of = {right: left for left, right in right_of.items()}
    parents = {joint.parent_name for joint in context.model.joints}
    continued = {joint.parent_name for pair in counterparts for joint in pair}
    for left, right in counterparts:
        parent = left.parent_name
        correct, wrong = (right, left) if parent in left_of else (left, right)
        link = right_of.get(parent) or left_of.get(parent)
        is_copied = wrong.child_name in continued or _have_one_place(left, right)
        if link and link not in parents and parent == right.parent_name and is_copied:
            yield correct, wrong, link, f"and '{link}' has no child"


def _have_one_place(left: Joint, right: Joint) -> bool:
    """True for joints of one link with the same frame and axis."""
    is_placed = is_equal(left.origin.position, right.origin.position)
    return is_placed and is_equally_turned(left, right) and direction(left) == direction(right)


def on_one_side(context: Context) -> Iterator[tuple[Joint, Joint, str, str]]:
    """Counterparts on one link that has a counterpart: correct and wrong joint, that link, and why.

    Others are on both links, so that these are sides of a body, not fingers of one hand.
    """
    above = {joint.child_name: joint for joint in context.model.joints}
    other: dict[str, str] = {}
    rights = set()
    links = pairs(above)
    for left, right in links:
        other |= {left: right, right: left}
        rights.add(right)
    split = {
        above[left].parent_name
        for left, right in links
        if other.get(above[left].parent_name) == above[right].parent_name
    }
    for left, right in links:
        parent = above[left].parent_name
        opposite = other.get(parent)
        if parent != above[right].parent_name or opposite is None or not has_one_side(left):
            continue
        if parent in split or opposite in split:
            correct, wrong = (right, left) if parent in rights else (left, right)
            reason = f"although that has the counterpart '{opposite}'"
            yield above[correct], above[wrong], opposite, reason


def on_another_branch(context: Context) -> Iterator[tuple[Joint, Joint, str]]:
    """Counterparts on links that are no counterparts: correct and wrong joint, and its parent.

    The parent of the wrong joint has a movable joint with a counterpart on its own counterpart; the
    link that should be the parent has none.
    """
    above = {joint.child_name: joint for joint in context.model.joints}
    parents = {child: joint.parent_name for child, joint in above.items()}
    links = on_separate_branches(pairs(above), parents)
    other = {a: b for left, right in links for a, b in ((left, right), (right, left))}
    movable = {joint.parent_name for joint in context.model.joints if joint.is_single_dof}
    matched = {
        parents[child]
        for child, counterpart in other.items()
        if above[child].is_single_dof and other.get(parents[child]) == parents[counterpart]
    }
    for child, counterpart in other.items():
        parent, link = parents[child], other.get(parents[counterpart])
        is_elsewhere = parent in matched and parent != parents[counterpart]
        if link and link not in movable and is_elsewhere and above[child].is_single_dof:
            yield above[counterpart], above[child], link


def _fixed_joints(context: Context, counterparts: list[_Pair]) -> list[tuple[Joint, Joint]]:
    """Fixed joints whose parents are counterparts on two sides, such as feet of shanks."""
    fixed = {joint.name: joint for joint in context.model.joints if joint.kind == "fixed"}
    movable = {(pair.left.child_name, pair.right.child_name) for pair in counterparts}
    return [
        (fixed[left], fixed[right])
        for left, right in pairs(fixed)
        if (fixed[left].parent_name, fixed[right].parent_name) in movable
    ]


def _pairs(context: Context, counterparts: list[tuple[Joint, Joint]]) -> Iterator[_Pair]:
    frames = context.tree.frames
    if len(context.tree.roots) != 1:
        return  # TRE002 comes first
    for left, right in counterparts:
        left_frame, right_frame = (frames.get(joint.child_name) for joint in (left, right))
        if left_frame and right_frame:
            (x, y, z), (a, b, c) = left_frame.position, right_frame.position
            if abs(y - b) > _ASYMMETRY:
                yield _Pair(left, right, (a - x, b + y, c - z))


def _asymmetric(
    counterparts: list[_Pair],
    movable: list[_Pair],
    context: Context,
    joints: Mapping[str, list[Joint]],
) -> list[_Pair]:
    """The pairs that are not mirror images although their parents are.

    Args:
        movable: the movable counterparts, with which fixed ones are compared.
    """
    known = {pair.right.child_name: pair.distance for pair in movable}
    all_pairs = list(dict.fromkeys((*counterparts, *movable)))
    # A joint may be anywhere along its axis, if the joint below it makes up for that.
    compensated = {p.right.parent_name for p in counterparts if p.distance <= _ASYMMETRY}
    asymmetric = []
    for pair in counterparts:
        is_shared = pair.left.parent_name == pair.right.parent_name
        above = 0.0 if is_shared else known.get(pair.right.parent_name, 0.0)
        is_alone = pair.distance > _ASYMMETRY >= above
        is_alone = is_alone and pair.right.child_name not in compensated
        if is_alone and not _are_sides_of_one_link(pair):
            asymmetric.append(pair)
    if single := _with_another_number(movable) if counterparts == movable else None:
        return [single]
    exact = sum(pair.distance <= TOLERANCE for pair in all_pairs)
    others = [pair.distance for pair in all_pairs if pair.distance <= _ASYMMETRY]
    is_single = len(asymmetric) == 1 and asymmetric[0].distance >= _MIN_RATIO * max(
        others, default=0
    )
    if is_single and exact >= _SYMMETRIC_PAIRS:
        x, _, z = asymmetric[0].offset
        if max(abs(x), abs(z)) > _ASYMMETRY and not _is_turned_copy(asymmetric[0], context):
            return asymmetric  # else the plane of symmetry may be another one
    return [
        pair
        for pair in asymmetric
        if _is_shifted_along_one_axis(pair)
        or (exact and _has_copied_offset(pair, context, joints))
        or (is_single and exact > _SYMMETRIC_PAIRS and _has_copied_origin(pair, context))
    ]


def _are_sides_of_one_link(pair: _Pair) -> bool:
    """True for counterparts to both sides of a link, whose sides may not be those of the robot.

    Such as the fingers of an arm that looks aside when all of its joints are zero.
    """
    place, other = _places(pair.left, pair.right)
    opposite = [
        axis
        for axis, (a, b) in enumerate(zip(place, other, strict=True))
        if abs(a + b) <= TOLERANCE < abs(a)
    ]
    mirrored = vector(-part if axis in opposite else part for axis, part in enumerate(place))
    is_shared = pair.left.parent_name == pair.right.parent_name
    return is_shared and len(opposite) == 1 and is_equal(mirrored, other)


def _with_another_number(movable: list[_Pair]) -> _Pair | None:
    """The pair that alone is not symmetric, because its origins differ in one number.

    Pairs below it are moved with it, unless they make up for it.
    """
    moved = [pair for pair in movable if pair.distance > TOLERANCE]
    below = {pair.right.child_name for pair in moved}
    first = [pair for pair in moved if pair.right.parent_name not in below]
    exact = [pair for pair in movable if pair not in moved]
    if len(first) != 1 or len(exact) < _EXACT_PAIRS:
        return None
    (pair,) = first
    sizes = [[abs(part) for part in place] for place in _places(pair.left, pair.right)]
    *equal, other = sorted(abs(a - b) for a, b in zip(*sizes, strict=True))
    is_compensated = any(pair.right.child_name == after.right.parent_name for after in exact)
    is_typo = max(equal) <= TOLERANCE and other >= _OTHER_NUMBER
    return pair if is_typo and not is_compensated else None


def _has_copied_offset(pair: _Pair, context: Context, joints: Mapping[str, list[Joint]]) -> bool:
    """True for counterparts on mirrored links, to the same side of them."""
    left, right = pair.left, pair.right
    frames, links = context.tree.frames, context.model.links_by_name
    if are_copies(links.get(left.parent_name), links.get(right.parent_name)):
        return False
    if right.kind != "continuous" and are_copies(*(_part(one, context) for one in (left, right))):
        return False
    if _are_two_machines(pair, context.tree):
        return False
    left_parent, right_parent = frames.get(left.parent_name), frames.get(right.parent_name)
    if left_parent is None or right_parent is None or left.parent_name == right.parent_name:
        return False
    is_followed = any(joint.is_single_dof for joint in joints.get(right.child_name, ()))
    if right.kind != "continuous" and not is_followed:
        return False  # both hands may have the same gripper
    place, right_place = frames[left.child_name].position, frames[right.child_name].position
    offset = minus(place, left_parent.position)
    is_copied = is_equal(offset, minus(right_place, right_parent.position))
    are_mirrored = is_equal(mirror_image(left_parent.position), right_parent.position)
    if not (are_mirrored and is_copied and abs(offset[1]) > _ASYMMETRY):
        return False
    siblings = (frames.get(joint.child_name) for joint in joints.get(right.parent_name, ()))
    # Another link has the place of the mirror image: only the names are not mirrored.
    image = mirror_image(place)
    return not any(frame and is_equal(frame.position, image) for frame in siblings)


def _are_two_machines(pair: _Pair, tree: KinematicTree) -> bool:
    """True for equal chains that are fixed to an empty root, such as two arms in a world."""
    root = tree.roots[0]
    left, right = (_chain(joint, tree) for joint in (pair.left, pair.right))
    if not root.is_frame or len(left) != len(right) or left[0] is right[0]:
        return False
    is_mounted = left[0].kind == right[0].kind == "fixed"
    moving = sum(joint.is_single_dof for joint in left)
    return is_mounted and moving > 1 and all(map(_are_alike, left[1:], right[1:]))


def _chain(joint: Joint, tree: KinematicTree) -> list[Joint]:
    """The joints from the root to a joint."""
    chain = [joint]
    while (above := tree.parents[chain[-1].parent_name]) and above[0] not in chain:
        chain.append(above[0])
    return chain[::-1]


def _are_alike(one: Joint, other: Joint) -> bool:
    is_placed = is_equal(one.origin.position, other.origin.position)
    is_turned = is_equally_turned(one, other) and direction(one) == direction(other)
    return is_placed and is_turned and one.kind == other.kind


def _part(joint: Joint, context: Context) -> Link | None:
    """The first link with a mesh from the parent of a joint on: plain shapes tell no product."""
    below = (
        context.model.links_by_name.get(name) for name in context.tree.below(joint.parent_name)
    )
    has_mesh = (link for link in below if link and any(body.file for body in link.visuals))
    return next(has_mesh, None)


def _has_copied_origin(pair: _Pair, context: Context) -> bool:
    """True for movable counterparts with the same origin to one side, and a mesh for each side.

    Fixed ones may be the same product, such as two cameras.
    """
    left, right = pair.left, pair.right
    place = left.origin.position
    links = (context.model.links_by_name.get(joint.child_name) for joint in (left, right))
    files = [body.file.value for link in links if link for body in link.visuals if body.file]
    is_copied = abs(place[1]) >= TOLERANCE and is_equal(place, right.origin.position)
    if not (is_copied and is_equally_turned(left, right) and right.is_single_dof):
        return False
    if _is_turned_copy(pair, context):
        return False
    return len(files) == 2 and bool(pairs(files))


def _is_turned_copy(pair: _Pair, context: Context) -> bool:
    """True for the same origin in frames that are turned: both arms are the same product."""
    left, right = pair.left, pair.right
    frames = [context.tree.frames.get(joint.parent_name) for joint in (left, right)]
    if None in frames or not is_equally_turned(left, right):
        return False
    first, second = (frame.rotation for frame in frames if frame)
    is_turned = any(dot(a, b) < _MAX_COSINE for a, b in zip(first, second, strict=True))
    return is_turned and is_equal(left.origin.position, right.origin.position)


def _is_shifted_along_one_axis(pair: _Pair) -> bool:
    """True for counterparts on one link that differ in x alone, or in z."""
    left, right = pair.left, pair.right
    if not is_equally_turned(left, right) or left.parent_name != right.parent_name:
        return False
    is_zero = [abs(part) <= TOLERANCE for part in pair.offset]
    return is_zero[1] and sum(is_zero) == 2


def _shift(pair: _Pair) -> str:
    """Such as ``is 0.03 m forward of the mirror image of 'left_hip'``."""
    x, y, z = pair.offset
    directions = ((x, "forward", "backward"), (y, "to the left", "to the right"), (z, "up", "down"))
    shifts = [
        f"{abs(part):.2g} m {plus if part > 0 else minus}"
        for part, plus, minus in directions
        if abs(part) > TOLERANCE
    ]
    return f"is {' and '.join(shifts)} of the mirror image of '{pair.left.name}'"


def _at(joint: Joint) -> str:
    return "at " + spaced(joint.origin.position, 4) + " m"

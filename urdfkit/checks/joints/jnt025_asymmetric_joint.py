"""A joint differs from its left or right counterpart.

Counterparts are matched by name (left and right, l and r, FL and FR, ...) or, for numbered joints,
by mirrored positions on one link, and are on different branches.

- Limits, type, damping, friction: if the left elbow has 80 N·m and the right one 1000, only one of
  them was corrected, and the robot pulls to one side. Limits may be equal, mirrored, or of equal
  range about another zero; the tolerance is a twentieth of the range, 1 % of effort and velocity,
  and a factor of two of damping and friction. If all pairs but one have the limits that follow from
  their axes, the one is reported, too: two hips that turn about x in the same direction have
  opposite limits.
  A fixed joint with limits is reported if its counterpart moves and no other pair is so.
- Parent: if both upper arms are children of the left shoulder, and the right one has no child, the
  right arm was copied. So was the left sole if both soles are children of the right foot. A
  left rear shank on the left front thigh is reported, too, if its counterpart is on the right rear
  thigh, and the left rear thigh has no shank.
- Origin: counterparts on one link differ in the sign of one coordinate. If they are at the same
  place, or one is further forward or higher, a sign is missing: the robot stands on three wheels.
  The other joints on that link show which counterpart is misplaced, otherwise left is +y. In the
  zero pose, a pair is reported as well if it is the only one of several pairs that is not a mirror
  image, also one that is fixed to movable counterparts, such as a foot; where four or more pairs
  are exact, a millimetre in one number suffices. Of four casters, the one
  that is not at the height or distance of the other three is; of two, the higher one.
- Fingers: one of at least four has five times the effort or velocity of all others, or a fifth, a
  position limit with another sign or decimal point, the opposite axis for the same limits, or a
  parent in another finger. In hands whose joints bend from zero to one side: the only joint that
  bends the other way than the others of its finger, or the only finger that does.
- Legs or wheels: one of at least four has the opposite axis for the same limits, or one other
  number in its origin.
- Axis: if the left hip turns about x, so does the right one, in either direction. Rotary joints are
  compared if their frames are mirror images in the plane y = 0 of the root, or x = 0.

Sources:
    unitreerobotics/unitree_ros#154: https://github.com/unitreerobotics/unitree_ros/issues/154
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    measured: of 671 public robots one has a misplaced pair, of wheels; of 1300 none another axis
"""

from collections.abc import Iterator, Mapping
from math import isclose, pi

from urdfkit.checks.joints.bending_fingers import bending_fingers
from urdfkit.checks.joints.fingers import odd_fingers
from urdfkit.checks.joints.mirrored import (
    misplaced,
    on_another_branch,
    on_one_side,
    on_the_other_side,
)
from urdfkit.checks.joints.odd_legs import odd_legs
from urdfkit.core.spatial import Z_AXIS, Transform, Vector, dot, rotate, rotation_about
from urdfkit.core.words import rounded
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import direction
from urdfkit.robot.placed import Placed
from urdfkit.robot.samples import hand_xml
from urdfkit.robot.symmetry import are_copies, pairs
from urdfkit.robot.values import number

_AXIS = '<axis xyz="0 1 0"/>'
_LIMIT = '<limit lower="-1" upper="2" effort="80" velocity="11"/>'
_LEFT, _RIGHT = '<origin xyz="0 0.2 0"/>', '<origin xyz="0 -0.2 0"/>'
BAD = hand_xml("revolute", [_LEFT, _AXIS, _LIMIT], [_RIGHT, _AXIS, _LIMIT.replace("80", "1000")])
GOOD = BAD.replace("1000", "80")

#: Relative tolerance of effort and velocity.
_TOLERANCE = 0.01
#: Tolerance of the positions of mirrored frames, in m: robots are not quite symmetric.
_MAX_OFFSET = 4e-3
#: A quarter turn about the vertical.
_TURN = Transform(rotation_about(Z_AXIS, pi / 2))
#: Cosine of the angle between two axes below which they are different, not rounded.
_MAX_COSINE = 0.5
#: Cosine of the angle between two axes above which they are parallel.
_PARALLEL = 0.99
#: Least number of pairs with mirrored limits next to one whose limits are not.
_CONSISTENT_PAIRS = 2
#: Allowed ratio of damping and friction, which are measured.
_MAX_LOSS_RATIO = 2.0
#: Relative difference of two ranges that differ by the place of zero alone.
_MAX_DIFFERENCE_OF_WIDTH = 1e-3
#: Tolerance as a part of the range; the legs of a NAO differ by 0.005 of it.
_RANGE_TOLERANCE = 0.05


@rule(Severity.WARNING, confidence=Confidence.INFERRED)
def check(context: Context) -> Findings:
    for first, second in context.symmetric_joints:
        if differences := list(_differences(first, second)):
            yield Finding(
                second.limit.at if second.limit and first.kind == second.kind else second.at,
                f"joint '{second.name}' differs from its counterpart '{first.name}': "
                + ", ".join(differences),
                "write the same value for both",
                related=_note(first),
                group_key="counterparts",
            )
    placed = set()
    for correct, misplaced_joint, reason in misplaced(context):
        placed |= {correct.name, misplaced_joint.name}
        yield Finding(
            misplaced_joint.at.child_or_self("origin"),
            f"joint '{misplaced_joint.name}' {reason}",
            "mirror its origin in the plane between the two",
            related=_note(correct),
        )
    for correct, wrong, parent, reason in (*on_the_other_side(context), *on_one_side(context)):
        yield Finding(
            wrong.at.child_or_self("parent"),
            f"joint '{wrong.name}' has the same parent '{wrong.parent_name}' as its counterpart "
            f"'{correct.name}', {reason}",
            f"name '{parent}' as its parent",
            related=_note(correct),
        )
    for correct, wrong, parent in on_another_branch(context):
        yield Finding(
            wrong.at.child_or_self("parent"),
            f"joint '{wrong.name}' has the parent '{wrong.parent_name}', its counterpart "
            f"'{correct.name}' has '{correct.parent_name}'",
            f"name '{parent}' as its parent",
            related=_note(correct),
        )
    yield from _axes(context)
    yield from _ranges(context)
    yield from _fixed(context)
    legs = (leg for leg in odd_legs(context) if leg.joint.name not in placed)
    for odd in (*legs, *bending_fingers(context), *odd_fingers(context)):
        yield Finding(
            odd.at,
            f"joint '{odd.joint.name}' {odd.difference}",
            odd.help,
            related=(Related(odd.other.at.span, f"joint '{odd.other.name}'"),),
        )


def _note(counterpart: Joint) -> tuple[Related]:
    return (Related(counterpart.at.span, f"counterpart '{counterpart.name}'"),)


def _fixed(context: Context) -> Findings:
    """The only fixed joint with limits whose counterpart moves."""
    joints = {joint.name: joint for joint in context.model.joints if joint.name}
    locked = []
    for left, right in pairs(joints):
        both = joints[left], joints[right]
        fixed, moving = sorted(both, key=lambda joint: joint.is_single_dof)
        if fixed.kind == "fixed" and moving.is_single_dof and _has_range(fixed):
            locked.append((fixed, moving))
    if len(locked) == 1:
        fixed, moving = locked[0]
        yield Finding(
            fixed.at,
            f"joint '{fixed.name}' is fixed, but its counterpart '{moving.name}' is {moving.kind}",
            f'write type="{moving.kind}", or remove the <limit>',
            related=_note(moving),
        )


def _has_range(joint: Joint) -> bool:
    limit = joint.limit
    return bool(limit and limit.lower and limit.upper and limit.lower.value < limit.upper.value)


def _differences(first: Joint, second: Joint) -> Iterator[str]:
    """The differences, as ``effort 1000, not 80 N·m``: the second's value before the first's."""
    if first.kind != second.kind:
        yield f"{second.kind}, not {first.kind}"
        return
    yield from _losses(first, second)
    one, other = first.limit, second.limit
    if one is None or other is None:
        return
    for name, a, b, unit_of_value in (
        ("effort", one.effort, other.effort, first.effort_unit),
        ("velocity", one.velocity, other.velocity, f"{first.unit}/s"),
    ):
        if a and b and _differ(a, b):
            yield f"{name} {b.value:g}, not {a.value:g} {unit_of_value}"
    ours, theirs = bounds(first), bounds(second)
    if ours is None or theirs is None or ours[0] >= ours[1] or theirs[0] >= theirs[1]:
        return
    mirrored = (-ours[1], -ours[0])
    if not (_same(ours, theirs) or _same(mirrored, theirs) or _are_shifted(ours, theirs)):
        yield (
            f"limits [{theirs[0]:g}, {theirs[1]:g}], not [{ours[0]:g}, {ours[1]:g}] {first.unit}"
        )


def _losses(first: Joint, second: Joint) -> Iterator[str]:
    """Differences in damping and friction, unless one of the joints mimics another."""
    one, other = (joint.at.child("dynamics") for joint in (first, second))
    if one is None or other is None or first.mimic or second.mimic:
        return
    of = first.effort_unit
    for key, dimension in (("damping", f"{of}·s/{first.unit}"), ("friction", of)):
        a, b = number(one.get(key)), number(other.get(key))
        if a and b and max(a, b) > _MAX_LOSS_RATIO * min(a, b) > 0:
            yield f"{key} {b:g}, not {a:g} {dimension}"


def _differ(a: Placed[float], b: Placed[float]) -> bool:
    high, low = max(a.value, b.value), min(a.value, b.value)
    return low > 0 and high - low > _TOLERANCE * high


def _same(ours: tuple[float, float], theirs: tuple[float, float]) -> bool:
    allowed = _RANGE_TOLERANCE * max(ours[1] - ours[0], theirs[1] - theirs[0])
    return abs(ours[0] - theirs[0]) <= allowed and abs(ours[1] - theirs[1]) <= allowed


def _are_shifted(ours: tuple[float, float], theirs: tuple[float, float]) -> bool:
    """True for limits that differ by the place of zero alone.

    Exporters of assemblies put it where the parts were drawn, and servos at half a turn.
    """
    return isclose(ours[1] - ours[0], theirs[1] - theirs[0], rel_tol=_MAX_DIFFERENCE_OF_WIDTH)


def _axes(context: Context) -> Findings:
    """Joints that turn about an axis other than that of their counterparts."""
    frames = _lateral_frames(context)
    for left, right in context.symmetric_joints:
        if not left.is_rotational or not right.is_rotational:
            continue
        left_frame, right_frame = (frames.get(joint.child_name) for joint in (left, right))
        if left_frame is None or right_frame is None or not _are_mirrored(left_frame, right_frame):
            continue
        a, b = _axis(left, left_frame), _axis(right, right_frame)
        if abs(dot((a[0], -a[1], a[2]), b)) < _MAX_COSINE:
            a, b = (_axis(each, context.tree.frames[each.child_name]) for each in (left, right))
            if abs(dot(a, b)) > _PARALLEL:
                continue  # an oblique one for both, as for balls, which turn about any axis
            yield Finding(
                right.at.child_or_self("axis"),
                f"joint '{right.name}' turns about {rounded(b, 3)} in the root frame, but its "
                f"counterpart '{left.name}' about {rounded(a, 3)}",
                "give both the same axis in the root frame, or the opposite one",
                related=(Related(left.at.child_or_self("axis").span, "axis of the counterpart"),),
            )


def _ranges(context: Context) -> Findings:
    """The only pair of several whose limits are not mirrored as the axes require."""
    wrong, consistent = [], 0
    leaders = {joint.leader for joint in context.model.joints}
    links, frames = context.model.links_by_name, _lateral_frames(context)
    for left, right in context.symmetric_joints:
        if not leaders.isdisjoint((left.name, right.name)):
            continue  # the same gripper on both sides, which opens alike
        if are_copies(links.get(left.child_name), links.get(right.child_name)):
            continue
        ours, theirs, is_opposite = bounds(left), bounds(right), _is_opposite(frames, left, right)
        if ours is None or theirs is None or is_opposite is None:
            continue
        mirrored = (-ours[1], -ours[0])
        if (is_equal := _same(ours, theirs)) is _same(mirrored, theirs):
            continue  # a symmetric range, or a difference that is reported already
        if is_equal is is_opposite:
            wrong.append((left, right, mirrored if is_opposite else ours))
        else:
            consistent += 1
    if len(wrong) != 1 or consistent < _CONSISTENT_PAIRS:
        return
    left, right, ends = wrong[0]
    lower, upper = (end or 0.0 for end in ends)  # no -0
    assert left.limit is not None
    assert right.limit is not None
    yield Finding(
        right.limit.at,
        f"joint '{right.name}': the mirror image of the limits of its counterpart '{left.name}' is "
        f"[{lower:g}, {upper:g}] {right.unit} about this axis",
        f'write lower="{lower:g}" upper="{upper:g}", correct those of the counterpart, or invert '
        "the axis of one",
        related=(Related(left.limit.at.span, "limits of the counterpart"),),
    )


def _lateral_frames(context: Context) -> Mapping[str, Transform]:
    """The frames of the links in a root frame whose y axis is lateral.

    That of some programs for CAD is the x axis, if the robot faces along y.
    """
    frames = context.tree.frames
    turned = {name: _TURN @ frame for name, frame in frames.items()}
    ends = [(left.child_name, right.child_name) for left, right in context.symmetric_joints]
    ends = [(left, right) for left, right in ends if left in frames and right in frames]
    if any(_are_mirrored(frames[left], frames[right]) for left, right in ends):
        return frames
    mirrored = sum(_are_mirrored(turned[left], turned[right]) for left, right in ends)
    return turned if mirrored > _CONSISTENT_PAIRS else frames


def _is_opposite(frames: Mapping[str, Transform], left: Joint, right: Joint) -> bool | None:
    """True if mirror images move in opposite directions, by the axes; None if it is unknown."""
    left_frame, right_frame = (frames.get(joint.child_name) for joint in (left, right))
    if left_frame is None or right_frame is None or not _are_mirrored(left_frame, right_frame):
        return None
    (x, y, z), axis = _axis(left, left_frame), _axis(right, right_frame)
    cosine = dot((x, -y, z) if left.is_prismatic else (-x, y, -z), axis)
    return cosine < 0 if abs(cosine) > _MAX_COSINE else None


def _are_mirrored(left: Transform, right: Transform) -> bool:
    (x, y, z), (a, b, c) = left.position, right.position
    return abs(y) > _MAX_OFFSET and max(abs(x - a), abs(y + b), abs(z - c)) <= _MAX_OFFSET


def _axis(joint: Joint, frame: Transform) -> Vector:
    """The axis of a joint in the root frame."""
    return rotate(frame.rotation, direction(joint))

"""The lower limit of a joint is not below its upper limit.

- A lower limit above the upper limit is an error: the range contains no position. Drake ends the
  program, Gazebo swaps them, MuJoCo and PyBullet read the joint as unlimited, MoveIt and Pinocchio
  compute with an empty range. It is a warning if MuJoCo, PyBullet and yourdfpy are the only
  targets. PyBullet's own robots write lower="1" upper="-1" for a free joint: in URDF a free
  revolute joint is `continuous`, and a free prismatic joint has limits that are far apart. If one
  limit is zero, the other has the wrong sign where another joint has it with the right one.
- Equal limits are a warning: MoveIt, Gazebo, Drake and Pinocchio hold the joint still, MuJoCo moves
  it without limit. urdfdom reads missing limits as 0, so a revolute joint with effort and velocity
  alone cannot move either. Drake, MuJoCo and PyBullet read them as none: this is not reported if
  Drake and MuJoCo are the only targets. A joint that never moves is fixed. Where Gazebo measures
  its force, such a joint is an info: a fixed joint would be merged.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
"""

from collections.abc import Mapping

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.joint import Joint, Limit
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import number
from urdfkit.text.editing.edits import fix_value, swap

BAD = arm_xml("revolute", '<limit lower="2.775" upper="-2.775" effort="30" velocity="1"/>')
FIXED = GOOD = BAD.replace('lower="2.775" upper="-2.775"', 'lower="-2.775" upper="2.775"')

#: Limits with which robots made for PyBullet mark a joint as free.
_FREE_IN_PYBULLET = ((1.0, -1.0), (1.0, 0.0), (0.0, -1.0))


@rule(Severity.ERROR)
def check(context: Context) -> Findings:
    is_optional = context.targets.all_are("ignores_limits")
    ranges: dict[object, Joint] = {
        (joint.kind, bounds(joint)): joint for joint in context.model.joints
    }
    for joint in context.model.joints:
        ends = bounds(joint)
        if joint.limit and ends and ends[0] > ends[1]:
            yield _inverted(joint, joint.limit, ends, ranges)
        elif joint.limit and ends and ends[0] == ends[1]:
            if is_optional and not {"lower", "upper"} <= joint.limit.at.attributes.keys():
                continue
            is_wanted = _is_locked(joint.limit) or _is_measured(context.model, joint.name)
            yield _equal(joint, joint.limit, ends[0], is_wanted)


def _inverted(
    joint: Joint, limit: Limit, ends: tuple[float, float], ranges: Mapping[object, Joint]
) -> Finding:
    lower, upper = ends
    message = (
        f"joint '{joint.name}': lower limit {lower:g} {joint.unit} is above upper limit "
        f"{upper:g} {joint.unit}"
    )
    for key in ("lower", "upper"):
        if key not in limit.at.attributes:
            message += f" ({key} is not written, so it is 0)"
    if ends in _FREE_IN_PYBULLET:
        free = "make it continuous" if joint.kind == "revolute" else "set them far apart"
        message += " (no limits for MuJoCo and PyBullet)"
        return Finding(limit.at, message, f"if the joint is to be free, {free}; else swap them")
    # One limit is zero, and the other has the right sign in another joint.
    like = ranges.get((joint.kind, (-lower, -upper))) if ends.count(0) == 1 else None
    if like:
        attribute = limit.at.attributes["lower" if lower else "upper"]
        text = attribute.value.strip()
        other = text.removeprefix("-") if text.startswith("-") else f"-{text}"
        help = f"write {attribute.name}=\"{other}\", as joint '{like.name}' has"
        return Finding(limit.at, message, help, fix_value(attribute, other))
    return Finding(limit.at, message, "swap them", _swapped(limit))


def _swapped(limit: Limit) -> Fix | None:
    lower, upper = limit.at.attributes.get("lower"), limit.at.attributes.get("upper")
    return Fix.of("swap lower and upper", swap(lower, upper)) if lower and upper else None


def _equal(joint: Joint, limit: Limit, value: float, is_wanted: bool) -> Finding:
    written = [key for key in ("lower", "upper") if key in limit.at.attributes]
    why = f"lower and upper limit are both {value:g} {joint.unit}"
    if not written:
        why = "lower and upper limit are not written, so both are 0 (none for Drake and PyBullet)"
    elif len(written) == 1:
        why = f"its {written[0]} limit is 0, and so is the one that is not written"
    continuous = "make it continuous if it has no end, " if joint.kind == "revolute" else ""
    return Finding(
        limit.at,
        f"joint '{joint.name}' is {joint.kind} but cannot move: {why}",
        f"set lower and upper, {continuous}or make it fixed",
        group_key="cannot move",
        severity=Severity.INFO if is_wanted else Severity.WARNING,
    )


def _is_locked(limit: Limit) -> bool:
    """True if the limits are 0 and so is effort or velocity: this keeps Gazebo from merging it."""
    effort, velocity, *ends = (
        number(limit.at.get(key) or "") == 0 for key in ("effort", "velocity", "lower", "upper")
    )
    return all(ends) and (effort or velocity)


def _is_measured(model: RobotModel, name: str) -> bool:
    """True if Gazebo measures the force in a joint: it would merge a fixed one, which has none."""
    from urdfkit.ros.gazebo.measured_joints import measured_joints

    return any(measured == name for measured, _, _ in measured_joints(model))

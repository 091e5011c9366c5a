"""A mimic joint leaves its limits, or moves a gripper's fingers in the same direction.

- The position of the joint is the leader's times `multiplier` plus `offset`. If the leader's range
  drives the joint beyond its own limits, a simulator that supports mimic pulls at a joint at its
  stop, and the leader stops early or shakes; MoveIt and RViz show the joint outside of its limits.
  Often only the sign of the multiplier is wrong, or limits were copied from the leader.
- One finger mimics the other. If both axes point to the same side and the multiplier is positive,
  the distance between the fingers stays the same: the gripper never closes. Invert one axis, or the
  sign of the multiplier.
- A mimic plugin of Gazebo has another multiplier than the `<mimic>` of its joint: RViz and MoveIt
  show another motion than the simulation.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

import re

from urdfkit.core.spatial import dot, length, minus, rotate
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import Joint, Mimic
from urdfkit.robot.joint_limits import bounds, overshoot
from urdfkit.robot.kinematics import direction
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import hand_xml
from urdfkit.robot.symmetry import pairs
from urdfkit.robot.values import number
from urdfkit.text.document import Element

_LIMIT = '<limit lower="0" upper="0.8" effort="20" velocity="2"/>'
BAD = hand_xml("revolute", [_LIMIT], [_LIMIT, '<mimic joint="left_joint" multiplier="-1"/>'])
GOOD = BAD.replace(' multiplier="-1"', "")

#: In m: smallest gap between fingers.
_MIN_GAP = 1e-3

#: Relative difference of two multipliers above which they are not equal.
_MAX_DIFFERENCE = 0.01

#: In the names of fingers.
_FINGER = "finger|jaw|claw"

#: Cosine of the angle up to which a finger moves along the gap.
_ALONG_GAP = 0.9


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    known = context.model.joints_by_name
    for joint in context.model.joints:
        leader = known.get(joint.leader)
        if joint.mimic and leader and leader is not joint:
            yield from _limits(joint, joint.mimic, leader)
            yield from _fingers(joint, joint.mimic, leader)
    yield from _plugins(context)


def _plugins(context: Context) -> Findings:
    """Mimic plugins with another multiplier than the joint."""
    for block in context.model.gazebo:
        for plugin in block.all("plugin"):
            if "mimic" in (plugin.get("filename") or ""):
                yield from _plugin(plugin, context.model)


def _plugin(plugin: Element, model: RobotModel) -> Findings:
    named, leader, written, shift = (
        plugin.child(tag) for tag in ("mimicJoint", "joint", "multiplier", "offset")
    )
    joint = model.joints_by_name.get(named.text.strip()) if named else None
    multiplier = number(written.text) if written else None
    if written is None or multiplier is None or joint is None or joint.mimic is None:
        return
    own = joint.mimic.multiplier
    is_led = leader is not None and leader.text.strip() == joint.leader
    # With another offset it is another function, which was computed.
    is_same = (number(shift.text) if shift else 0.0) == joint.mimic.offset
    if is_led and is_same and abs(multiplier - own) > _MAX_DIFFERENCE * abs(own):
        yield Finding(
            written,
            f"plugin '{plugin.get('name')}' moves joint '{joint.name}' by {multiplier:g} times "
            f"'{joint.leader}', its <mimic> by {own:g} times",
            "write the same multiplier in both",
            related=(Related(joint.mimic.at.span, "the <mimic>"),),
            confidence=Confidence.INFERRED,
        )


def _limits(joint: Joint, mimic: Mimic, leader: Joint) -> Findings:
    own, leading = bounds(joint), bounds(leader)
    if own is None or leading is None or own[0] >= own[1] or leading[0] > leading[1]:
        return  # JNT003
    taken = _taken(leading, mimic.multiplier, mimic.offset)
    if overshoot(taken, own) <= 0:
        return
    assert leader.limit is not None
    multiplier = mimic.at.attributes.get("multiplier")
    yield Finding(
        multiplier if multiplier and "offset" not in mimic.at.attributes else mimic.at,
        f"joint '{joint.name}': the mimic of '{leader.name}' drives it through [{taken[0]:g}, "
        f"{taken[1]:g}] {joint.unit}, beyond its limits [{own[0]:g}, {own[1]:g}]",
        _advice(mimic, leading, taken, own),
        related=(Related(leader.limit.at.span, f"the limits of '{leader.name}'"),),
        group_key="beyond",
    )


def _taken(leading: tuple[float, float], multiplier: float, offset: float) -> tuple[float, float]:
    ends = sorted(end * multiplier + offset for end in leading)
    return ends[0] + 0.0, ends[1] + 0.0  # no -0


def _advice(
    mimic: Mimic, leading: tuple[float, float], taken: tuple[float, float], own: tuple[float, float]
) -> str:
    """Where a sign is wrong, the limits may have it as well as the multiplier."""
    turned = _taken(leading, -mimic.multiplier, mimic.offset)
    if overshoot(turned, own) <= 0:
        return (
            f'if it turns the right way, write lower="{taken[0]:g}" upper="{taken[1]:g}"; '
            f"else multiplier {-mimic.multiplier:g}"
        )
    return "correct multiplier and offset, or the limits of one of the two"


def _fingers(joint: Joint, mimic: Mimic, leader: Joint) -> Findings:
    if not _are_fingers(joint, leader) or abs(mimic.multiplier) != 1:
        return
    gap = minus(leader.origin.position, joint.origin.position)
    ways = (rotate(one.origin.rotation, direction(one)) for one in (joint, leader))
    ours, theirs = (dot(way, gap) for way in ways)
    along = min(abs(ours), abs(theirs)) > _ALONG_GAP * length(gap) > _ALONG_GAP * _MIN_GAP
    ways_agree = ours * theirs > 0
    if length(gap) < _MIN_GAP and _are_named_fingers(joint, leader):  # only one is turned
        first, second = (rotate(one.origin.rotation, direction(one)) for one in (joint, leader))
        ways_agree = dot(first, second) > 0
        along = abs(dot(first, second)) > _ALONG_GAP
    if along and ways_agree is (mimic.multiplier > 0):
        yield Finding(
            mimic.at,
            f"joint '{joint.name}' mimics '{leader.name}' and moves in the same direction: the "
            "gripper cannot close",
            "invert the axis of one of the two, or the sign of the multiplier",
            related=(Related(leader.at.span, f"joint '{leader.name}'"),),
            confidence=Confidence.INFERRED,
        )


def _are_named_fingers(joint: Joint, leader: Joint) -> bool:
    """True for a left and a right finger, or two numbered ones, by the names of their links."""
    names = joint.child_name, leader.child_name
    are_two = bool(pairs(names)) or len({re.sub(r"\d+", "", name) for name in names}) == 1
    return are_two and all(re.search(_FINGER, name.lower()) for name in names)


def _are_fingers(joint: Joint, leader: Joint) -> bool:
    """True for two prismatic joints on one link with the same travel, unlike stages of a lift."""
    return (
        joint.kind == leader.kind == "prismatic"
        and bool(joint.parent_name)
        and joint.parent_name == leader.parent_name
        and not leader.mimic
    )

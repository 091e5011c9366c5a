"""A mimic joint moves a gripper's fingers in the same direction, so that it never closes.

One finger mimics the other. If both axes point to the same side and the multiplier is positive, the
distance between the fingers stays the same. Invert one axis, or the sign of the multiplier.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from urdfkit.core.spatial import dot, length, minus, rotate
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.kinematics import direction
from urdfkit.robot.model import Joint
from urdfkit.robot.samples import hand_xml

_LIMIT = '<limit lower="0" upper="0.04" effort="10" velocity="0.1"/>'
_LEFT = '<origin xyz="0 0.01 0.05"/>', '<axis xyz="0 1 0"/>', _LIMIT
_RIGHT = '<origin xyz="0 -0.01 0.05"/>', '<axis xyz="0 1 0"/>', _LIMIT
BAD = hand_xml("prismatic", _LEFT, (*_RIGHT, '<mimic joint="left_joint"/>'))
GOOD = BAD.replace('-0.01 0.05"/>\n  <axis xyz="0 1 0"/>', '-0.01 0.05"/>\n  <axis xyz="0 -1 0"/>')

#: In m: smallest gap between fingers.
_NEAR = 1e-3

#: Cosine of the angle up to which a finger moves along the gap.
_ALONG = 0.9


@rule(Severity.WARNING, help="invert the axis of one of the two, or the sign of the multiplier")
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        leader = context.model.joints_by_name.get(joint.leader)
        if joint.mimic is None or leader is None or not _are_fingers(joint, leader):
            continue
        gap = minus(leader.origin.position, joint.origin.position)
        ways = (rotate(one.origin.rotation, direction(one)) for one in (joint, leader))
        ours, theirs = (dot(way, gap) for way in ways)
        along = min(abs(ours), abs(theirs)) > _ALONG * length(gap) > _ALONG * _NEAR
        if along and ours * theirs * joint.mimic.multiplier > 0:
            yield Finding(
                joint.mimic.at,
                f"joint '{joint.name}' mimics '{leader.name}' and moves in the same direction: the "
                "gripper cannot close",
                related=(Related(leader.at.span, f"joint '{leader.name}'"),),
                confidence=Confidence.INFERRED,
            )


def _are_fingers(joint: Joint, leader: Joint) -> bool:
    """True for two prismatic joints on one link with the same travel, unlike stages of a lift."""
    return (
        joint.kind == leader.kind == "prismatic"
        and bool(joint.parent_name)
        and joint.parent_name == leader.parent_name
        and not leader.mimic
        and joint.mimic is not None
        and abs(joint.mimic.multiplier) == 1
    )

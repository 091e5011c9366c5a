"""A mimic joint moves a gripper's fingers in the same direction, so that it never closes.

One finger mimics the other. If both axes point to the same side and the multiplier is positive, the
distance between the fingers stays the same. Invert one axis, or the sign of the multiplier.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from urdfkit.core.spatial import dot, length, minus, rotate
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.kinematics import direction
from urdfkit.robot.model import Joint
from urdfkit.text.diagnostic import Confidence, Related, Severity

_FINGER = """\
<link name="{side}_finger"/>
<joint name="{side}_joint" type="prismatic">
  <parent link="palm"/>
  <child link="{side}_finger"/>
  <origin xyz="0 {y} 0.05"/>
  <axis xyz="0 {axis} 0"/>
  <limit lower="0" upper="0.04" effort="10" velocity="0.1"/>{mimic}
</joint>
"""
_MIMIC = '\n  <mimic joint="left_joint"/>'
_LEFT = '<link name="palm"/>\n' + _FINGER.format(side="left", y=0.01, axis=1, mimic="")
BAD = _LEFT + _FINGER.format(side="right", y=-0.01, axis=1, mimic=_MIMIC)
GOOD = _LEFT + _FINGER.format(side="right", y=-0.01, axis=-1, mimic=_MIMIC)

#: In m: fingers nearer to each other than this have no gap to close.
_NEAR = 1e-3

#: Cosine of the angle up to which a finger moves along the gap.
_ALONG = 0.9


@rule(Severity.WARNING, help="invert the axis of one of the two, or the sign of the multiplier")
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        target = joint.mimic.joint if joint.mimic else None
        leader = subject.model.joints_by_name.get(target.value) if target else None
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
    """True for two sliding joints on one link that go equally far; stages of a lift do not."""
    return (
        joint.kind == leader.kind == "prismatic"
        and joint.parent is not None
        and leader.parent is not None
        and joint.parent.value == leader.parent.value
        and not leader.mimic
        and joint.mimic is not None
        and abs(joint.mimic.multiplier) == 1
    )

"""A joint mimics a joint that has no single position.

Only revolute, continuous and prismatic joints have one number to pass on. Drake refuses a robot in
which a fixed joint leads or follows; MuJoCo and MoveIt drop the coupling, so that the follower
hangs loose. A fixed joint that follows does no harm elsewhere and is reported for Drake only.
Remove the `<mimic>`, or give the joint its type back.

Sources:
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import MOVING, related, several
from urdfkit.text.diagnostic import Severity
from urdfkit.text.schema import JOINT_TYPES

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint

BAD = """\
<link name="hand"/>
<link name="left_finger"/>
<link name="right_finger"/>
<joint name="left_finger_joint" type="fixed">
  <parent link="hand"/>
  <child link="left_finger"/>
</joint>
<joint name="right_finger_joint" type="prismatic">
  <parent link="hand"/>
  <child link="right_finger"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
  <mimic joint="left_finger_joint"/>
</joint>"""
GOOD = BAD.replace('  <mimic joint="left_finger_joint"/>\n', "")

_SINGLE = frozenset(MOVING)
_OTHERS = frozenset(JOINT_TYPES) - _SINGLE


@rule(
    "JNT017",
    "mimic-of-fixed",
    Severity.WARNING,
    help="remove the <mimic>, or give the joint a type that moves",
    by_target={"drake": Severity.ERROR},
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding per reason: who fixes a hand, fixes all of its fingers."""
    known = subject.model.joints_by_name
    drake = subject.targets.any_of(["drake"])
    found: dict[str, list[Joint]] = {}
    for joint in subject.model.joints:
        leader = known.get(joint.mimic.joint.value) if joint.mimic and joint.mimic.joint else None
        if leader is None or leader is joint:
            continue
        if joint.kind in _OTHERS and drake:
            found.setdefault(f"<mimic> on a {joint.kind} joint", []).append(joint)
        elif leader.kind in _OTHERS and joint.kind in _SINGLE:
            reason = f"<mimic> of '{leader.name}', which is {leader.kind}"
            found.setdefault(reason, []).append(joint)
    for reason, joints in found.items():
        assert joints[0].mimic is not None
        yield Finding(
            joints[0].mimic.at,
            f"{several(joints)}: {reason}",
            related=related((joint, joint.mimic.at.span) for joint in joints if joint.mimic),
        )

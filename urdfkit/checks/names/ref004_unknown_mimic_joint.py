"""A joint mimics a joint that the model does not have.

urdfdom does not look, and each program finds out on its own: Drake refuses the robot, MoveIt
drops the coupling, joint_state_publisher stops with an exception. Correct the name.

Sources:
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
    joint_state_publisher.py: https://github.com/ros/joint_state_publisher/blob/ros2/joint_state_publisher/joint_state_publisher/joint_state_publisher.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="hand"/>
<link name="left_finger"/>
<link name="right_finger"/>
<joint name="left_finger_joint" type="prismatic">
  <parent link="hand"/>
  <child link="left_finger"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
</joint>
<joint name="right_finger_joint" type="prismatic">
  <parent link="hand"/>
  <child link="right_finger"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
  <mimic joint="left_fingr_joint"/>
</joint>"""
GOOD = BAD.replace("left_fingr_joint", "left_finger_joint")
FIXED = GOOD


@rule(
    "REF004",
    "unknown-mimic-joint",
    Severity.ERROR,
    help="correct the name, or add the joint",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    known = subject.model.joints_by_name
    suggester = Suggester(known)
    for joint in subject.model.joints:
        leader = joint.mimic.at.attributes.get("joint") if joint.mimic else None
        if leader is None or leader.value in known or is_expression(leader.value):
            continue
        hint = suggester.hint(leader.value)
        yield Finding(
            leader,
            f"joint '{joint.name}' mimics '{leader.value}', which is not in the model{hint}",
            fix=_renamed(leader, suggester.suggested(leader.value)),
        )


def _renamed(leader: Attribute, suggested: str) -> Fix | None:
    edits = replace_value(leader, suggested) if suggested else None
    return Fix.of(f"rename '{leader.value}' to '{suggested}'", edits)

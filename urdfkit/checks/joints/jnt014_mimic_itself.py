"""A joint mimics itself.

Its position would be a multiple of itself, which is 0 or nothing. Drake and MuJoCo refuse the
robot, and MoveIt drops every mimic of it. Name the joint that leads, or remove the `<mimic>`.

Sources:
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

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
  <mimic joint="right_finger_joint"/>
</joint>"""
GOOD = BAD.replace('mimic joint="right', 'mimic joint="left')


@rule("JNT014", "mimic-itself", Severity.ERROR, help="name the joint that leads")
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        leader = joint.mimic.joint if joint.mimic else None
        if leader and joint.name and leader.value == joint.name:
            yield Finding(leader, f"joint '{joint.name}' mimics itself")

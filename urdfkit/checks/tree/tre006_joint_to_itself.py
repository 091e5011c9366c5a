"""A joint has the same link as parent and child.

urdfdom loops forever on it, Pinocchio crashes, and sdformat rejects the model. One of the two
names is a mistake: the child is the link that moves.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.text.diagnostic import Severity

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="fixed">
  <parent link="base"/>
  <child link="base"/>
</joint>"""
GOOD = BAD.replace('<child link="base"/>', '<child link="arm"/>')


@rule(Severity.ERROR, help="name the link that this joint moves as its child")
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        if joint.parent and joint.child and joint.parent.value == joint.child.value:
            yield Finding(
                joint.child,
                f"joint '{joint.name}' has link '{joint.child.value}' as parent and as child",
            )

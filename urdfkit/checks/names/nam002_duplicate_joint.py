"""Two joints have the same name.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio), Drake and PyBullet refuse the robot. It happens when a
macro is called twice without a prefix, or a joint is copied. Give one of them another name.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="left_wheel"/>
<link name="right_wheel"/>
<joint name="axle" type="continuous">
  <parent link="base"/>
  <child link="left_wheel"/>
</joint>
<joint name="axle" type="continuous">
  <parent link="base"/>
  <child link="right_wheel"/>
</joint>"""
GOOD = BAD.replace("axle", "left_axle", 1)


@rule(
    "NAM002",
    "duplicate-joint",
    Severity.ERROR,
    help="give each joint its own name, in a macro by a prefix",
)
def check(subject: Subject) -> Iterator[Finding]:
    first = subject.model.joints_by_name
    for joint in subject.model.joints:
        if joint.name and first[joint.name] is not joint:
            yield Finding(
                joint.at.attributes["name"],
                f"a second joint is called '{joint.name}'",
                related=(Related(first[joint.name].at.span, "the first"),),
            )

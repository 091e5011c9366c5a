"""Two links have the same name.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio), MuJoCo, Drake and PyBullet refuse the robot. It happens
when a macro is called twice without a prefix, or a link is copied. Give one of them another name,
and name it in the joints that mean it.

Sources:
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    MuJoCo, user_model.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_model.cc
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
<link name="wheel"/>
<link name="wheel"/>
<joint name="left" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
</joint>"""
GOOD = """\
<link name="base"/>
<link name="wheel"/>
<joint name="left" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
</joint>"""


@rule(
    "NAM001",
    "duplicate-link",
    Severity.ERROR,
    help="give each link its own name, in a macro by a prefix",
)
def check(subject: Subject) -> Iterator[Finding]:
    first = subject.model.links_by_name
    for link in subject.model.links:
        if link.name and first[link.name] is not link:
            yield Finding(
                link.at.attributes["name"],
                f"a second link is called '{link.name}'",
                related=(Related(first[link.name].at.span, "the first"),),
            )

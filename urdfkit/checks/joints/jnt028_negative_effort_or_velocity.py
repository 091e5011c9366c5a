"""Joints have a negative effort or velocity limit.

It is the greatest amount, in either direction, so it cannot be below 0. Pinocchio refuses the
robot, and Drake ends the program on a negative velocity; Gazebo takes it for "no limit", as SDF
has it, ros2_control and MoveIt for the same number without the sign. Write the limit, or a
generous one where there is none.

Sources:
    Pinocchio, URDF joints: https://github.com/stack-of-tasks/pinocchio/blob/devel/include/pinocchio/parsers/urdf/model.hxx
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import MOVING, effort_unit, related, several, unit
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="leg"/>
<joint name="hip" type="revolute">
  <parent link="base"/>
  <child link="leg"/>
  <limit lower="-1" upper="1" effort="-1" velocity="3"/>
</joint>"""
GOOD = BAD.replace('effort="-1"', 'effort="80"')


@rule(
    "JNT028",
    "negative-effort-or-velocity",
    Severity.ERROR,
    help="write the greatest amount, which is positive",
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding each: who writes -1 for one joint, mostly does so for every other."""
    joints = [joint for joint in subject.model.joints if joint.kind in MOVING and joint.limit]
    efforts = [(joint, joint.limit.effort) for joint in joints if joint.limit]
    velocities = [(joint, joint.limit.velocity) for joint in joints if joint.limit]
    for key, limits in (("effort", efforts), ("velocity", velocities)):
        below = [(joint, limit) for joint, limit in limits if limit and limit.value < 0]
        if below:
            first, limit = below[0]
            of = effort_unit(first) if key == "effort" else f"{unit(first)}/s"
            yield Finding(
                limit,
                f"{several([joint for joint, _ in below])}: the {key} limit is {limit.value:g} "
                f"{of}, below 0",
                related=related((joint, limit.span) for joint, limit in below),
            )

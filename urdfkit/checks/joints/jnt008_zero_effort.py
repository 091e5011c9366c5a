"""Joints have an effort limit of zero.

A limit of 0 is a limit: no motor of these joints can deliver a force. Gazebo and ros2_control cut
every effort command to 0, and PyBullet's usual call with the URDF's limit leaves the robot limp.
CAD exporters and many drawings of industrial arms write 0 for "not known". Give the force or the
torque that the motor can deliver, and a generous one if you do not know it. Joints without a
transmission or ros2_control are taken for passive where others have one.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    unitreerobotics/unitree_ros#154: https://github.com/unitreerobotics/unitree_ros/issues/154
    agilexrobotics/ugv_gazebo_sim#47: https://github.com/agilexrobotics/ugv_gazebo_sim/issues/47
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import effort_unit, limited_to_zero, related, several
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="finger"/>
<joint name="knuckle" type="revolute">
  <parent link="base"/>
  <child link="finger"/>
  <limit lower="0" upper="1.7453" effort="0" velocity="2"/>
</joint>"""
GOOD = BAD.replace('effort="0"', 'effort="1.2"')


@rule(
    "JNT008",
    "zero-effort",
    Severity.WARNING,
    help="give the force or torque that the motor can deliver",
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding for all: who writes 0 for one joint, mostly does so for every other."""
    found = limited_to_zero(subject.model, "effort")
    if found:
        joints = [joint for joint, _ in found]
        yield Finding(
            found[0][1],
            f"{several(joints)}: the effort limit is 0 {effort_unit(joints[0])}",
            related=related([(joint, effort.span) for joint, effort in found]),
        )

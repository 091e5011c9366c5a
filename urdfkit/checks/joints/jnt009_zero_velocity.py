"""Joints have a velocity limit of zero.

A limit of 0 is a limit: ros2_control and DART, Gazebo's default physics, hold such a joint where
it is, even against gravity. MoveIt takes 0 for "no limit" and then cannot time a trajectory. CAD
exporters write 0 for "not known". Give the greatest speed of the motor. Joints without a
transmission or ros2_control are taken for passive where others have one.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    ros2_control, joint limiting: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joint_limiting.rst
    MoveIt, time parameterization: https://github.com/moveit/moveit2/blob/main/moveit_core/trajectory_processing/src/time_optimal_trajectory_generation.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import limited_to_zero, related, several, unit
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="finger"/>
<joint name="knuckle" type="revolute">
  <parent link="base"/>
  <child link="finger"/>
  <limit lower="0" upper="1.7453" effort="1.2" velocity="0"/>
</joint>"""
GOOD = BAD.replace('velocity="0"', 'velocity="2"')


@rule(
    "JNT009",
    "zero-velocity",
    Severity.WARNING,
    help="give the greatest speed of the joint",
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding for all: who writes 0 for one joint, mostly does so for every other."""
    found = limited_to_zero(subject.model, "velocity")
    if found:
        joints = [joint for joint, _ in found]
        yield Finding(
            found[0][1],
            f"{several(joints)}: the velocity limit is 0 {unit(joints[0])}/s",
            related=related([(joint, velocity.span) for joint, velocity in found]),
        )

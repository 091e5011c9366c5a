"""The axis of a joint has no direction.

MuJoCo and Drake refuse the robot, Gazebo drops the model; Pinocchio goes on with a rotation that
is none and shrinks what hangs on the joint. An `<axis>` without `xyz` is 0 0 0 for urdfdom, not
the default axis. Write the direction, such as 0 0 1, in the frame of the joint.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import MOVING
from urdfkit.robot.model import length
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="wheel"/>
<joint name="axle" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
  <axis xyz="0 0 0"/>
</joint>"""
GOOD = BAD.replace("0 0 0", "0 1 0")

#: sdformat's bound; MuJoCo's is smaller.
_TINY = 1e-6


@rule("JNT005", "zero-axis", Severity.ERROR, help="write the direction of the axis")
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        axis = joint.at.child("axis")
        if axis is None or joint.kind not in (*MOVING, "planar"):
            continue
        if "xyz" not in axis.attributes:
            yield Finding(axis, f"joint '{joint.name}': <axis> has no xyz and is read as 0 0 0")
        elif joint.axis and length(joint.axis.value) < _TINY:
            text = " ".join(f"{value:g}" for value in joint.axis.value)
            yield Finding(joint.axis, f"joint '{joint.name}': the axis {text} has no direction")

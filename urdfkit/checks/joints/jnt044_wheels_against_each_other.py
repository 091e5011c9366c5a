"""The two wheels of a robot turn against each other.

The axes of the left and the right wheel point in opposite directions. Drive plugins and controllers
give both one speed to go straight, so that the robot turns on the spot instead, and its odometry
says that it went straight. Some robots are built so, and the program that drives them turns one
sign: then ignore this. Where a drive plugin of Gazebo is known, GAZ026 tells it, and RCT025 where a
controller is.

Sources:
    ros2_controllers, diff_drive_controller: https://control.ros.org/rolling/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    measured: of 671 public robots six are so.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.spatial import dot, rotate
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.kinematics import direction
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Joint

_WHEEL = """\
<link name="{side}_wheel"/>
<joint name="{side}_wheel_joint" type="continuous">
  <parent link="base"/>
  <child link="{side}_wheel"/>
  <origin xyz="0 {y} 0"/>
  <axis xyz="0 {axis} 0"/>
</joint>
"""
_LEFT = _WHEEL.format(side="left", y=0.2, axis=1)
BAD = f'<link name="base"/>\n{_LEFT}{_WHEEL.format(side="right", y=-0.2, axis=-1)}'
GOOD = BAD.replace("0 -1 0", "0 1 0")

#: Names of joints that do not roll a wheel along.
_OTHERS = ("caster", "castor", "swivel", "steer", "mecanum", "omni", "roller")

#: Cosine of the angle of two opposite axes.
_OPPOSITE = -0.95


@rule(
    "JNT044",
    "wheels-against-each-other",
    Severity.INFO,
    help="turn one <axis> round, unless the program that drives the robot turns a sign",
)
def check(subject: Subject) -> Iterator[Finding]:
    wheels = [
        (one, other) for one, other in subject.symmetric_joints if _roll(one) and _roll(other)
    ]
    frames = subject.tree.frames
    if len(wheels) != 1:
        return
    ((left, right),) = wheels
    here, there = (frames.get(joint.child.value) for joint in (left, right) if joint.child)
    if here is None or there is None:
        return
    one, other = rotate(here.rotation, direction(left)), rotate(there.rotation, direction(right))
    if dot(one, other) < _OPPOSITE:
        yield Finding(
            right.at.child("axis") or right.at,
            f"joint '{right.name}' turns its wheel against the other one, '{left.name}'",
            related=(Related((left.at.child("axis") or left.at).span, f"joint '{left.name}'"),),
            confidence=Confidence.INFERRED,
        )


def _roll(joint: Joint) -> bool:
    name = f"{joint.name} {joint.child.value if joint.child else ''}".lower()
    return (
        joint.kind == "continuous"
        and joint.mimic is None
        and "wheel" in name
        and not any(word in name for word in _OTHERS)
    )

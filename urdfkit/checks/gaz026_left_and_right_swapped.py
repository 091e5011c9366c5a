"""A drive plugin has left and right interchanged, or the axes of its wheels against each other.

The axis of the wheels says which way the robot rolls for a positive speed, and so which side is
left. With the sides interchanged the robot turns right when told to turn left; with opposite axes
it turns on the spot when told to go straight.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    AutonomyLab/create_robot#77: https://github.com/AutonomyLab/create_robot/issues/77
    vislab-tecnico-lisboa/vizzy#68: https://github.com/vislab-tecnico-lisboa/vizzy/issues/68
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Related, Severity
from urdfkit.gazebo.drives import Wheel, between, dot, drive_of, pairs, wheels
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.gazebo.plugins import Use
    from urdfkit.subject import Subject

_WHEEL = """\
<link name="{side}_wheel">
  <inertial>
    <mass value="0.2"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
  </inertial>
</link>
<joint name="{side}_joint" type="continuous">
  <parent link="base"/>
  <child link="{side}_wheel"/>
  <origin xyz="0 {y} 0"/>
  <axis xyz="0 1 0"/>
</joint>
"""
BAD = f"""\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
{_WHEEL.format(side="left", y=0.17)}{_WHEEL.format(side="right", y=-0.17)}<gazebo>
  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
    <leftJoint>right_joint</leftJoint>
    <rightJoint>left_joint</rightJoint>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("<leftJoint>right", "<leftJoint>left").replace(
    "<rightJoint>left", "<rightJoint>right"
)


@rule(
    "GAZ026",
    "left-and-right-swapped",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        kind = drive_of(use)
        if kind is None or kind.steered or use.values("legacyMode"):
            continue
        for left, right in pairs(list(wheels(use, subject.tree))):
            if finding := _judged(use, left, right):
                yield finding
                break


def _judged(use: Use, left: Wheel, right: Wheel) -> Finding | None:
    parallel = dot(left.axis, right.axis)
    to_left = dot(between(left.hub or left.origin, right.hub or right.origin), left.axis)
    if abs(parallel) < 0.999 or abs(to_left) < 0.01:
        return None
    note = Related(right.reference.item.at.span, f"and the right joint is '{right.joint.name}'")
    if parallel < 0:
        return Finding(
            left.reference.item.at,
            f"{use.title}: the axes of '{left.joint.name}' and '{right.joint.name}' point in "
            "opposite directions, so that going straight turns the robot",
            "turn the axis of one of the joints",
            related=(note,),
        )
    if to_left > 0:
        return None
    return Finding(
        left.reference.item.at,
        f"{use.title}: the left joint '{left.joint.name}' is {-to_left:.3g} m to the right of "
        f"'{right.joint.name}' as the robot rolls, so that it turns the wrong way",
        "interchange the joints, or turn both axes",
        related=(note,),
    )

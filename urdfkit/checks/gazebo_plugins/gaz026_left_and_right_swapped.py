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

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.ros.gazebo.drives import drive_of, pairs, wheels, wrong_sides
from urdfkit.ros.gazebo.samples import WHEELED
from urdfkit.text.diagnostic import Related, Severity

BAD = (
    WHEELED
    + """\
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
    <leftJoint>right_joint</leftJoint>
    <rightJoint>left_joint</rightJoint>
  </plugin>
</gazebo>"""
)
GOOD = BAD.replace("<leftJoint>right", "<leftJoint>left").replace(
    "<rightJoint>left", "<rightJoint>right"
)


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Findings:
    for use in subject.plugins:
        kind = drive_of(use)
        if kind is None or kind.steered or use.values("legacyMode"):
            continue
        for left, right in pairs(list(wheels(use, subject.tree))):
            if wrong := wrong_sides(left.rolling, right.rolling):
                message, help = wrong
                other = f"and the right joint is '{right.reference.name}'"
                yield Finding(
                    left.reference.item.at,
                    f"{use.title}: {message}",
                    help,
                    related=(Related(right.reference.item.at.span, other),),
                )
                break

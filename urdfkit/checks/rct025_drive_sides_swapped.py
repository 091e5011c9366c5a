"""A wheel controller has left and right interchanged, or wheels that turn against each other.

The controller rolls both sides forwards by turning their joints in the positive sense, and takes
the first list for the left. With the lists interchanged the robot turns to the wrong side and its
odometry with it; with axes that point in opposite directions it spins instead of going straight.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.controllers import Controller, controllers
from urdfkit.diagnostic import Related, Severity
from urdfkit.gazebo.drives import Rolling, between, dot, rolling
from urdfkit.placed_yaml import Value
from urdfkit.rules import Finding, Written, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

_WHEEL = """\
<link name="{side}_wheel">
  <collision>
    <origin rpy="1.5707963 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </collision>
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
{_WHEEL.format(side="left", y=0.15)}{_WHEEL.format(side="right", y=-0.15)}\
<ros2_control name="base" type="system">
  <hardware>
    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
  </hardware>
  <joint name="left_joint">
    <command_interface name="velocity"/>
    <state_interface name="position"/>
  </joint>
  <joint name="right_joint">
    <command_interface name="velocity"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>
<gazebo>
  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
    <parameters>/home/student/arm_description/config/bad.yaml</parameters>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    drive:
      type: diff_drive_controller/DiffDriveController
drive:
  ros__parameters:
    left_wheel_names: [left_joint]
    right_wheel_names: [right_joint]
    wheel_separation: 0.3
    wheel_radius: 0.1
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"left_joint", b"?")
    .replace(b"right_joint", b"left_joint")
    .replace(b"?", b"right_joint"),
    "config/good.yaml": _YAML,
}

_LEFT = ("left_wheel_names", "left_wheel")
_RIGHT = ("right_wheel_names", "right_wheel")


@rule("RCT025", "drive-sides-swapped", Severity.WARNING)
def check(subject: Subject) -> Iterator[Finding]:
    for file, found in controllers(subject):
        for controller in found:
            left, right = controller.values(_LEFT)[:1], controller.values(_RIGHT)[:1]
            if "diff_drive" not in controller.type or not left or not right:
                continue
            wheels = [_wheel(value, subject) for value in (*left, *right)]
            if wheels[0] and wheels[1] and (told := _judged(wheels[0], wheels[1])):
                message, help = told
                yield Finding(
                    Written(left[0].span),
                    f"{_who(controller)}: {message.format(left[0].text, right[0].text)}",
                    help,
                    related=(Related(file.span, "the file is named here"),),
                )


def _who(controller: Controller) -> str:
    return f"controller '{controller.name}'"


def _wheel(value: Value, subject: Subject) -> Rolling | None:
    joint = subject.model.joints_by_name.get(value.text)
    return rolling(joint, subject.tree) if joint else None


def _judged(left: Rolling, right: Rolling) -> tuple[str, str] | None:
    """What is wrong with two wheels, and the remedy."""
    parallel = dot(left.axis, right.axis)
    to_left = dot(between(left.hub or left.origin, right.hub or right.origin), left.axis)
    if abs(parallel) < 0.999 or abs(to_left) < 0.01:
        return None
    if parallel < 0:
        return (
            (
                "the axes of '{}' and '{}' point in opposite directions, so that going straight "
                "turns the robot"
            ),
            "turn the axis of one of the joints",
        )
    if to_left > 0:
        return None
    return (
        (
            f"the left joint '{{}}' is {-to_left:.3g} m to the right of '{{}}' as the robot rolls, "
            "so that it turns the wrong way"
        ),
        "interchange the joints, or turn both axes",
    )

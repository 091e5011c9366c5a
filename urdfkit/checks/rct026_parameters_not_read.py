"""Nobody reads a part of the file of controllers.

The file is no YAML, `ros__parameters` is misspelt (two underscores), or parameters stand under a
name that no controller has. The controller then starts without its joints, and stops: "parameter
'joints' was not set".

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.controllers import lost, unparsed
from urdfkit.diagnostic import Related, Severity
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
    "config/bad.yaml": _YAML.replace(b"drive:\n  ros__parameters", b"drive:\n  ros_parameters"),
    "config/good.yaml": _YAML,
}


@rule("RCT026", "parameters-not-read", Severity.ERROR, help="mend the file of controllers")
def check(subject: Subject) -> Iterator[Finding]:
    for file, span, reason in unparsed(subject):
        note = Related(file.span, "the file is named here")
        yield Finding(Written(span), f"the file is no YAML: {reason}", related=(note,))
    for file, found in lost(subject):
        note = Related(file.span, "the file is named here")
        for span, message, help in found:
            yield Finding(Written(span), message, help, related=(note,))

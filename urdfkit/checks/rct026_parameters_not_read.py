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

BAD = """\
<link name="base">
  <inertial>
    <mass value="3"/>
    <inertia ixx="0.03" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.03"/>
  </inertial>
</link>
<link name="arm">
  <inertial>
    <mass value="0.5"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
  </inertial>
</link>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="arm"/>
</joint>
<gazebo>
  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
    <parameters>/home/student/arm_description/config/bad.yaml</parameters>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    arm:
      type: position_controllers/JointGroupPositionController
arm:
  ros__parameters:
    joints: [shoulder]
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"arm:\n  ros__parameters", b"arm:\n  ros_parameters"),
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

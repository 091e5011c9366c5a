"""A joint of ros2_control follows another one by a parameter that newer versions do not read.

In Humble and Iron `<param name="mimic">` and `<param name="multiplier">` couple a joint in a
simulator. From Jazzy on these are passed over, the joint does not follow, and its command interface
is what moves it: write `<mimic>` into the joint of the URDF, and leave the command interface out.

Sources:
    ros2_control#1553: https://github.com/ros-controls/ros2_control/pull/1553
    ros2_control, joints: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joints_userdoc.rst
    gz_ros2_control#340: https://github.com/ros-controls/gz_ros2_control/issues/340
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import components, parameter
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

_LINK = """\
<link name="{}">
  <inertial>
    <mass value="0.1"/>
    <inertia ixx="1e-4" ixy="0" ixz="0" iyy="1e-4" iyz="0" izz="1e-4"/>
  </inertial>
</link>
"""
BAD = (
    "".join(map(_LINK.format, ("hand", "left_finger", "right_finger")))
    + """\
<joint name="left" type="prismatic">
  <parent link="hand"/>
  <child link="left_finger"/>
  <axis xyz="0 1 0"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
</joint>
<joint name="right" type="prismatic">
  <parent link="hand"/>
  <child link="right_finger"/>
  <axis xyz="0 -1 0"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
</joint>
<ros2_control name="hand" type="system">
  <hardware>
    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
  </hardware>
  <joint name="left">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
  <joint name="right">
    <param name="mimic">left</param>
    <param name="multiplier">1</param>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
)
GOOD = BAD.replace(
    'velocity="0.2"/>\n</joint>\n<ros2',
    'velocity="0.2"/>\n  <mimic joint="left"/>\n</joint>\n<ros2',
)
TARGETS = ("gz-harmonic",)

_HUMBLE = ("classic-ros2", "gz-fortress")
_JAZZY = ("gz-harmonic", "gz-jetty")


@rule(
    "RCT031",
    "mimic-by-parameter",
    Severity.WARNING,
    help="write <mimic> into the joint of the URDF",
)
def check(subject: Subject) -> Iterator[Finding]:
    targets = subject.targets
    if targets.any_of(_HUMBLE) or not targets.any_of(_JAZZY):
        return
    for component in components(subject.model):
        for part in component.joints:
            follows = parameter(part.at, "mimic")
            joint = subject.model.joints_by_name.get(part.name)
            if follows is None or joint is None or joint.mimic:
                continue
            message = f"joint '{part.name}' follows '{follows.text.strip()}' by a parameter"
            yield Finding(
                follows,
                f"{message}, which ros2_control does not read from Jazzy on",
                confidence=Confidence.INFERRED,
            )

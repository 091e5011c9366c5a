"""A joint that mimics another one has a command interface of its own.

From ROS 2 Jazzy on the controller manager stops: "Activated mimic joints cannot have command
interfaces". Humble does not read `<mimic>` here and lets a controller move the follower by itself.
Keep only state interfaces, or write `mimic="false"` in the block's joint if it has a motor of its
own. A joint with the parameters `mimic` and `multiplier` is written for Humble, and not reported.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, joints: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joints_userdoc.rst
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import components, parameter
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="hand"/>
<link name="left_finger"/>
<link name="right_finger"/>
<joint name="left_finger_joint" type="prismatic">
  <parent link="hand"/>
  <child link="left_finger"/>
  <axis xyz="0 1 0"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
</joint>
<joint name="right_finger_joint" type="prismatic">
  <parent link="hand"/>
  <child link="right_finger"/>
  <axis xyz="0 -1 0"/>
  <limit lower="0" upper="0.04" effort="20" velocity="0.2"/>
  <mimic joint="left_finger_joint"/>
</joint>
<ros2_control name="hand" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="left_finger_joint">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
  <joint name="right_finger_joint">
    <command_interface name="velocity"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace('    <command_interface name="velocity"/>\n', "")


@rule(
    "RCT008",
    "command-on-mimic",
    Severity.ERROR,
    help='delete the command interface, or write mimic="false" in this joint of <ros2_control>',
    by_target=dict.fromkeys(("classic-ros2", "gz-fortress"), Severity.WARNING),  # of Humble
)
def check(subject: Subject) -> Iterator[Finding]:
    for component in components(subject.model):
        for part in component.joints:
            joint = subject.model.joints_by_name.get(part.name)
            commands = part.of("command")
            if joint is None or joint.mimic is None or not commands:
                continue
            if (part.at.get("mimic") or "").lower() == "false" or parameter(part.at, "mimic"):
                continue
            leader = joint.mimic.joint.value if joint.mimic.joint else ""
            yield Finding(
                commands[0].at,
                f"joint '{part.name}' mimics '{leader}' and has "
                f"command interface '{commands[0].name}'",
            )

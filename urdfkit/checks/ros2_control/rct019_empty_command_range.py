"""The range of a command interface is empty: its least value is above its greatest.

From ROS 2 Jazzy on the resource manager clamps commands into that range, and refuses one that is
empty; older ones hand the numbers to the hardware. The two were probably swapped.

Sources:
    ros2_control, joint limiting: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joint_limiting.rst
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="10" velocity="1"/>
</joint>
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position">
      <param name="min">0.9</param>
      <param name="max">-0.9</param>
    </command_interface>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace("-0.9", "1.0")


@rule("RCT019", "empty-command-range", Severity.ERROR, help="swap min and max")
def check(subject: Subject) -> Iterator[Finding]:
    for component in components(subject.model):
        for part in component.parts:
            for interface in part.interfaces:
                least, greatest = interface.bound("min"), interface.bound("max")
                at = interface.parameter("min")
                if at and least is not None and greatest is not None and least > greatest:
                    yield Finding(
                        at,
                        f"{part.kind} '{part.name}': the range of {interface.name} ends at "
                        f"{greatest:g}, below its beginning at {least:g}",
                    )

"""A joint of ros2_control takes commands and tells nothing.

No block gives the joint a state interface. Most controllers, the one for trajectories and the one
for wheels among them, do not start without the position or the velocity of their joints, and the
joint is absent in the joint states, from which TF gets the pose of its link.

Sources:
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
    joint_trajectory_controller, requirements: https://control.ros.org/rolling/doc/ros2_controllers/joint_trajectory_controller/doc/userdoc.html
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
    <command_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace(
    '<command_interface name="position"/>',
    '<command_interface name="position"/>\n    <state_interface name="position"/>',
)


@rule(
    "RCT033",
    "no-state-interface",
    Severity.WARNING,
    help='add <state_interface name="position"/>, and velocity if the hardware has it',
)
def check(subject: Subject) -> Iterator[Finding]:
    blocks = components(subject.model)
    telling = {part.name for block in blocks for part in block.parts if part.of("state")}
    for block in blocks:
        for part in block.joints:
            if part.of("command") and part.name and part.name not in telling:
                message = f"joint '{part.name}' has command interfaces and no state interface"
                yield Finding(part.at, message)

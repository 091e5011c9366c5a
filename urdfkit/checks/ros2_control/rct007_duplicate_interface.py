"""Two blocks of ros2_control, or one of them twice, declare the same interface of a joint.

From ROS 2 Jazzy on the controller manager stops: "Tried to insert CommandInterface with already
existing key". In Humble one of the two wins. The usual cause is that the block for the real
hardware and the one for the simulation are both active: choose one by a xacro argument.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Related, Severity

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
    <state_interface name="position"/>
  </joint>
</ros2_control>
<ros2_control name="arm_sim" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD[: BAD.index('<ros2_control name="arm_sim"')]


@rule("RCT007", "duplicate-interface", Severity.ERROR, help="keep one of them")
def check(subject: Subject) -> Iterator[Finding]:
    """One finding for each joint: with two blocks, all of its interfaces are there twice."""
    first: dict[tuple[str, ...], Related] = {}
    reported: set[tuple[int, str]] = set()
    for number, component in enumerate(components(subject.model)):
        for part in component.parts:
            for interface in part.interfaces:
                # Of one name, <sensor> and <gpio> are two things to the drivers that have both.
                key = (part.kind, part.name, interface.direction, interface.name)
                if not part.name or not interface.name:
                    continue
                if key not in first:
                    first[key] = Related(interface.at.span, f"first here, in {component.called}")
                elif (number, part.name) not in reported:
                    reported.add((number, part.name))
                    yield Finding(
                        interface.at,
                        f"{part.kind} '{part.name}': {interface.direction} interface "
                        f"'{interface.name}' is declared twice",
                        related=(first[key],),
                        alike=component.called,
                    )

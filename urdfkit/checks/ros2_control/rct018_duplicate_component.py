"""Two blocks of ros2_control have the same name.

The controller manager keeps its hardware by name: it reports "Hardware name is duplicated" and
starts without it. Only the control plugins of Gazebo do not look. A macro that is called for two
arms must put its prefix into the name of the block, too.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import Component, components
from urdfkit.text.diagnostic import Related, Severity
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="left"/>
<link name="right"/>
<joint name="left_wheel" type="continuous">
  <parent link="base"/>
  <child link="left"/>
  <axis xyz="0 1 0"/>
</joint>
<joint name="right_wheel" type="continuous">
  <parent link="base"/>
  <child link="right"/>
  <axis xyz="0 1 0"/>
</joint>
<ros2_control name="left" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="left_wheel">
    <command_interface name="velocity"/>
    <state_interface name="velocity"/>
  </joint>
</ros2_control>
<ros2_control name="left" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="right_wheel">
    <command_interface name="velocity"/>
    <state_interface name="velocity"/>
  </joint>
</ros2_control>"""
GOOD = "right".join(BAD.rsplit("left", 1))


@rule(
    "RCT018",
    "duplicate-component",
    Severity.WARNING,
    help="give each <ros2_control> a name of its own",
)
def check(subject: Subject) -> Iterator[Finding]:
    first: dict[str, Component] = {}
    for component in components(subject.model):
        name = component.name
        if name in first:
            yield Finding(
                component.at.attributes["name"],
                f"two <ros2_control> have the name '{name}'",
                related=(Related(first[name].at.span, "first here"),),
            )
        elif name and not is_expression(name):  # RCT017, XAC003
            first[name] = component

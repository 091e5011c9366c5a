"""A block of ros2_control names no hardware plugin.

The parser stops with an exception, and the controller manager does not start. Name the class of the
hardware; `mock_components/GenericSystem` is one for tests without hardware. A block that leaves the
choice to arguments of xacro is passed over.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, mock components: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/mock_components_userdoc.rst
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.ros_control import called, components
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

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
  <hardware/>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace(
    "<hardware/>", "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
)


#: A plugin, or all of the hardware, within a condition.
_CONDITIONAL = re.compile(
    r"<xacro:(if|unless)\b(?:(?!</xacro:\1).)*?<(?:hardware|plugin)\b", re.DOTALL
)


@rule(
    "RCT005",
    "plugin-missing",
    Severity.ERROR,
    help="write <hardware><plugin>package/Class</plugin></hardware> into the block",
)
def check(subject: Subject) -> Iterator[Finding]:
    for component in components(subject.model):
        hardware = component.at.child("hardware")
        if component.plugin is None and _is_left_to_arguments(component.at):
            continue
        if hardware is None:
            yield Finding(component.at, f"{component.called} has no <hardware>")
        elif component.plugin is None:
            yield Finding(hardware, f"{component.called}: its <hardware> has no <plugin>")
        elif not component.hardware:
            yield Finding(component.plugin, f"{component.called}: its <plugin> is empty")
        for transmission in component.at.all("transmission"):
            plugin = transmission.child("plugin")
            if plugin is None or not plugin.text.strip():
                yield Finding(
                    transmission,
                    f"{called(transmission)} names no <plugin>",
                    "write <plugin>transmission_interface/SimpleTransmission</plugin> into it",
                )


def _is_left_to_arguments(component: Element) -> bool:
    """True if the block names a plugin behind a condition that does not hold here.

    Such a robot is started with other arguments, and without them it only shows itself.
    """
    return bool(_CONDITIONAL.search(component.tag_at.whole_span.text))

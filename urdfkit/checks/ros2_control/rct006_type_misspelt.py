"""The type of a block of ros2_control is not `system`, `actuator` or `sensor`.

The controller manager reads the block and loads nothing from it, without an error: the controllers
then miss every interface. Capital letters count. A block without a type is an exception.

Sources:
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.ros_control import component_types
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Attribute

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="10" velocity="1"/>
</joint>
<ros2_control name="arm" type="System">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace('"System"', '"system"')
FIXED = GOOD


@rule(
    "RCT006", "type-misspelt", Severity.ERROR, help="write system, actuator or sensor", fixable=True
)
def check(subject: Subject) -> Iterator[Finding]:
    known = component_types()
    for component in components(subject.model):
        kind = component.at.attributes.get("type")
        if kind is None:
            yield Finding(component.at, f"{component.called} has no type")
        elif kind.value not in known and not is_expression(kind.value):
            hint = did_you_mean(kind.value, known)
            yield Finding(
                kind,
                f"{component.called} has type '{kind.value}', not {', '.join(known)}{hint}",
                fix=_fix(kind, known),
            )


def _fix(kind: Attribute, known: list[str]) -> Fix | None:
    suggested = nearest(kind.value, known)
    edits = replace_value(kind, suggested) if suggested else None
    return Fix.of(f"write {suggested}", edits)

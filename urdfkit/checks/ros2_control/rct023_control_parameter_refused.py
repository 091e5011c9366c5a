"""A parameter of an interface is misspelt, or a value in `<ros2_control>` is not a number.

`min`, `max` and `initial_value` are read by name. One with a slip in its name does nothing, and the
joint starts at 0 or is commanded without bounds; text that is not a number makes the hardware throw
when it is loaded. So do the attributes `rw_rate`, which is 0 or more, and `size` of an interface,
which is 1 or more.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, mock components: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/mock_components_userdoc.rst
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.model import number
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.grammar import is_expression

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
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position">
      <param name="inital_value">0.5</param>
    </state_interface>
  </joint>
</ros2_control>"""
GOOD = BAD.replace("inital_value", "initial_value")
FIXED = GOOD

_NUMBERS = ("min", "max", "initial_value")
#: How like the name a word must be to be taken for a slip of it.
_TYPO = 0.85


@rule("RCT023", "control-parameter-refused", Severity.WARNING, fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    for component in components(subject.model):
        yield from _integer(component.at, "rw_rate", 0, f"<ros2_control> '{component.name}'")
        for part in component.parts:
            for interface in part.interfaces:
                who = f"{part.kind} '{part.name}', {interface.name}"
                yield from _integer(interface.at, "size", 1, who)
                for element in interface.at.all("param"):
                    yield from _judged(who, element)


def _integer(element: Element, name: str, least: int, who: str) -> Iterator[Finding]:
    """An attribute that is read as an integer."""
    attribute = element.attributes.get(name)
    text = attribute.value.strip() if attribute else ""
    if attribute is None or is_expression(text):
        return
    if not (text.isascii() and text.isdecimal() and int(text) >= least):
        message = f"{who}: {name} is '{text}', and must be an integer of {least} or more"
        yield Finding(attribute, message, f"write an integer of {least} or more")


def _judged(who: str, element: Element) -> Iterator[Finding]:
    name, text = element.attributes.get("name"), element.text.strip()
    if name is None:
        return  # RCT017
    if name.value in _NUMBERS:
        if number(text) is None and not is_expression(text):
            shown = f"'{text}'" if text else "empty"
            message = f"{who}: parameter '{name.value}' is {shown}, and no number"
            yield Finding(element, message, "write a number", alike="no number")
    elif suggested := nearest(name.value, ("initial_value",), _TYPO):
        edits = replace_value(name, suggested)
        fix = Fix.of(f"rename it to {suggested}", edits)
        message = f"{who}: parameter '{name.value}' is nearly '{suggested}'"
        yield Finding(name, message, f"write {suggested}", fix)

"""A joint, sensor or hardware in `<ros2_control>` holds an element that nothing reads.

The parser takes what it knows and passes over the rest: a misspelt interface is missing, and a
controller that needs it cannot be activated; a misspelt parameter keeps its default.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.ros_control import grammar
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rename_element

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
    <comand_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace("comand_", "command_")
FIXED = GOOD

#: How like a tag a word must be to be taken for a slip of it.
_TYPO = 0.8


@rule(
    "RCT022",
    "unknown-control-element",
    Severity.WARNING,
    help="fix the name of the tag, or remove it",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    tags = grammar()
    for block in subject.model.ros2_controls:
        stack = [child for child in reversed(block.children) if child.tag in tags]
        while stack:
            element = stack.pop()
            known = tags[element.tag].children
            for child in element.children:
                if child.tag not in known and ":" not in child.tag:
                    yield _finding(element, child, known)
            # A transmission has joints and actuators of its own.
            if element.tag != "transmission":
                stack += [child for child in reversed(element.children) if child.tag in tags]


def _finding(element: Element, child: Element, known: Iterable[str]) -> Finding:
    name = element.get("name")
    who = f"{element.tag} '{name}'" if name else f"<{element.tag}>"
    hint = did_you_mean(child.tag, known)
    message = f"{who} in <ros2_control>: unknown element <{child.tag}>{hint}"
    suggested = nearest(child.tag, known, _TYPO)
    edits = rename_element(child, suggested) if suggested else None
    return Finding(child, message, fix=Fix.of(f"rename it to <{suggested}>", edits))

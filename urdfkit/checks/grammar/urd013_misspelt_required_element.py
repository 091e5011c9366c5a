"""An element that the robot cannot do without is misspelt.

Readers pass over the unknown name and find the needed element missing. Without `<inertial>` Gazebo
leaves the link out, with all that hangs on it; without `<geometry>`, `<mass>` or a shape, urdfdom
drops all shapes of the link; without `<parent>` or `<child>` it refuses the robot. Correct the
name.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rename_element
from urdfkit.text.grammar import owner

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertal>
    <mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.02"/>
  </inertal>
</link>"""
GOOD = BAD.replace("inertal", "inertial")
FIXED = GOOD


@rule("URD013", "misspelt-required-element", Severity.ERROR, fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    for element, _, _, suggested in subject.deviations.get("URD013", ()):
        edits = rename_element(element, suggested)
        title = f"rename <{element.tag}> to <{suggested}>"
        yield Finding(
            element,
            f"{owner(element)}: URDF has no <{element.tag}>, and the <{suggested}> that it seems "
            "to be is missing",
            title,
            Fix.of(title, edits),
        )

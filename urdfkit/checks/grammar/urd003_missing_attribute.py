"""An element lacks an attribute that it cannot do without.

In a joint, urdfdom (and with it RViz, MoveIt, Gazebo and Pinocchio) then refuses the whole robot.
In a link it logs one line, drops every visual and collision of that link and goes on, so that the
robot loads with holes in it. A `<dynamics>` needs at least one of its two attributes.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rename_attribute
from urdfkit.text.grammar import owner

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="wheel">
  <visual>
    <geometry><cylinder radus="0.1" length="0.05"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("radus", "radius")
FIXED = GOOD


@rule(
    "URD003",
    "missing-attribute",
    Severity.ERROR,
    help="add the attribute",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for element, attribute, missing, suggested in subject.deviations.get("URD003", ()):
        message = f"{owner(element)}: <{element.tag}> has no '{missing}'"
        if attribute is None:
            yield Finding(element, message, alike=f"{missing} of {element.tag}")
            continue
        edits = rename_attribute(attribute, suggested)
        yield Finding(
            attribute,
            f"{message}, but '{attribute.name}', which URDF does not know",
            f"rename {attribute.name} to {suggested}",
            Fix.of(f"rename {attribute.name} to {suggested}", edits),
        )

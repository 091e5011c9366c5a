"""The name of a tag in a plugin is misspelt.

Gazebo hands every tag to the plugin, which asks for those that it knows and takes its default where
there is none: a misspelt tag has no effect and causes no message.

Sources:
    tu-darmstadt-ros-pkg/hector_gazebo#65: https://github.com/tu-darmstadt-ros-pkg/hector_gazebo/issues/65
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import rename_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_planar_move.so">
    <robotBaseFrme>base</robotBaseFrme>
    <odometryFrame>odom</odometryFrame>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("Frme", "Frame")
FIXED = GOOD


@rule(
    "GAZ032",
    "misspelt-parameter",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for use, found in subject.unread:
        if found.suggested is None or found.other is not None:
            continue
        element, name = found.item.at, found.suggested
        assert isinstance(element, Element)
        edits = rename_element(element, name)
        yield Finding(
            element,
            f"{use.title} does not read <{element.tag}>",
            f"did you mean <{name}>?",
            Fix.of(f"rename it to <{name}>", edits),
            alike=use.filename,
        )

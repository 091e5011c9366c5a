"""An element lacks a child that it cannot do without.

A joint without `<parent>` or `<child>` makes urdfdom (RViz, MoveIt, Gazebo, Pinocchio) refuse the
robot. An `<inertial>` without `<mass>` or `<inertia>`, and a visual or collision without
`<geometry>`, make it drop the inertia, or all visuals and collisions, of the link: one line in the
log, and a robot with holes in it.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.grammar import owner

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="2"/>
  </inertial>
</link>"""
GOOD = """\
<link name="base">
  <inertial>
    <mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.02"/>
  </inertial>
</link>"""


@rule("URD004", "missing-element", Severity.ERROR, help="add the element")
def check(subject: Subject) -> Iterator[Finding]:
    for element, _, missing, _ in subject.deviations.get("URD004", ()):
        who = owner(element)
        inside = "" if who.startswith(element.tag) else f": <{element.tag}>"
        yield Finding(element, f"{who}{inside} has no <{missing}>", f"add <{missing}>")

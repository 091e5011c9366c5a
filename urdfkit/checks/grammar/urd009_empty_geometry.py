"""A `<geometry>` holds no shape that URDF knows, or something else before the shape.

URDF's shapes are box, cylinder, sphere, mesh and, from version 1.1, capsule; readers take the
first element whatever it is. urdfdom (RViz, MoveIt, Gazebo, Pinocchio) logs one line and drops
every visual and collision of the link, PyBullet refuses the robot. A plane is a thin box. A
`<material>` belongs after the `<geometry>`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.grammar import owner
from urdfkit.text.schema import SHAPES

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="floor">
  <collision>
    <geometry><plane normal="0 0 1"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace('<plane normal="0 0 1"/>', '<box size="10 10 0.01"/>')


@rule(
    "URD009",
    "empty-geometry",
    Severity.ERROR,
    help=f"let its first element be one of {', '.join(SHAPES)}",
)
def check(subject: Subject) -> Iterator[Finding]:
    for element, *_ in subject.deviations.get("URD009", ()):
        who = owner(element)
        if element.tag == "geometry":
            yield Finding(element, f"{who}: <geometry> holds no shape")
        else:
            yield Finding(
                element, f"{who}: <geometry> begins with <{element.tag}>, which is not a shape"
            )

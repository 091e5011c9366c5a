"""A mesh is scaled to nothing.

A factor of 0 makes the mesh a sheet, a line or a point: RViz shows nothing or an artefact, and
collision engines fail on triangles without area. A decimal point moved, as in `0.000 0.001 0.001`,
or an argument of the xacro was left at 0. Write the factors along x, y and z; millimetres are
`0.001 0.001 0.001`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.shapes import shaped
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="arm.stl" scale="0 0.001 0.001"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace('"0 0.001', '"0.001 0.001')
FILES = {"arm.stl": PLATE}


@rule("GEO005", "zero-scale", Severity.ERROR, help="write three factors other than 0")
def check(subject: Subject) -> Iterator[Finding]:
    for link, body, shape in shaped(subject.model):
        if shape.kind == "mesh" and 0 in shape.scale:
            factors = "{:g} {:g} {:g}".format(*shape.scale)
            yield Finding(
                shape.at.attributes["scale"],
                f"link '{link.name}': the mesh of its {body.at.tag} is scaled by {factors}",
            )

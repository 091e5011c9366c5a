"""A mesh is mirrored by a negative scale.

The factors turn every triangle inside out. Where a program does not flip them back, the part is
shaded wrongly, inside and outside of a collision are swapped, and a volume computed from the mesh
is negative. A mirrored copy of the mesh file is right everywhere. (Two negative factors are a
rotation by 180 degrees, and harmless.)

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    measured: 19 of 676 public models mirror meshes so, on purpose
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.model import Shape
from urdfkit.robot.samples import collision_xml, link_xml
from urdfkit.robot.shapes import shaped
from urdfkit.text.diagnostic import Related, Severity

BAD = link_xml("left_arm", collision_xml('<mesh filename="right_arm.stl" scale="1 -1 1"/>'))
GOOD = BAD.replace("right_arm.stl", "left_arm.stl").replace(' scale="1 -1 1"', "")
FILES = {"left_arm.stl": PLATE}

#: Other places that the finding lists.
_MAX_RELATED = 20


@rule(Severity.INFO, help="mirror the mesh file itself")
def check(subject: Subject) -> Findings:
    mirrored = [
        (link.name, body.at.tag, shape)
        for link, body, shape in shaped(subject.model)
        if shape.kind == "mesh" and shape.scale[0] * shape.scale[1] * shape.scale[2] < 0
    ]
    if mirrored:
        (name, tag, shape), *others = mirrored
        more = f" (and {len(others)} more like this)" if others else ""
        yield Finding(
            shape.at.attributes["scale"],
            f"link '{name}': the mesh of its {tag} is mirrored by scale {_factors(shape)}{more}",
            related=tuple(
                Related(shape.at.attributes["scale"].span, f"link '{name}': its {tag}")
                for name, tag, shape in others[:_MAX_RELATED]
            ),
        )


def _factors(shape: Shape) -> str:
    return "{:g} {:g} {:g}".format(*shape.scale)

"""A size or a scale of a shape is negative or zero.

- A negative size is an error: MuJoCo rejects the robot, other engines fail or create an inverted
  box, RViz draws it inside out. Often a formula in the xacro subtracts too much.
- A size of 0 is often written to mean "no shape". RViz draws nothing, Gazebo and Drake create a
  point; MuJoCo rejects the robot, and some collision engines divide by the volume. Remove the whole
  `<visual>` or `<collision>`: a link without one is valid. An error for MuJoCo, otherwise an info.
- A scale factor of 0 flattens a mesh to a sheet, a line or a point, and collision engines fail with
  triangles without area: an error. A decimal point is misplaced, as in `0.000 0.001 0.001`, or an
  argument of the xacro is 0. Millimetres are `0.001 0.001 0.001`.
- One or three negative scale factors mirror a mesh: every triangle is inside out. If a program does
  not flip them back, the part is shaded wrongly, inside and outside of a collision are swapped, and
  a volume computed from the mesh is negative. A mirrored mesh file works in all programs. An info.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    measured: 19 of 676 public models mirror meshes like this, on purpose
    Drake, URDF geometry: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_geometry.cc
"""

from math import prod

from urdfkit.core.words import spaced
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Severity, rule
from urdfkit.robot.samples import collision_xml, link_xml
from urdfkit.robot.shapes import shaped, sizes
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import fix_value

BAD = link_xml("arm", collision_xml('<box size="0.1 -0.2 0.3"/>'))
FIXED = GOOD = BAD.replace("-0.2", "0.2")


@rule(Severity.ERROR, help="write a positive size in m")
def check(context: Context) -> Findings:
    for link, body, shape in shaped(context.model):
        who = f"link '{link.name}': the <{shape.kind}> in its {body.at.tag} has"
        for attribute, values in sizes(shape):
            message = f"{who} {attribute.name} {spaced(values)} m"
            if min(values) < 0:
                yield Finding(attribute, message, fix=_fix(attribute))
            elif min(values) == 0:
                fatal = context.targets.that("rejects_empty_shapes")
                help = "remove the whole <visual> or <collision>"
                severity = Severity.ERROR if fatal else Severity.INFO
                yield Finding(attribute, message, help, severity=severity, targets=fatal)
        if shape.kind == "mesh" and 0 in shape.scale:
            message = f"{who} scale {spaced(shape.scale)}"
            yield Finding(shape.at.attributes["scale"], message, "write three factors other than 0")
        elif shape.kind == "mesh" and prod(shape.scale) < 0:
            yield Finding(
                shape.at.attributes["scale"],
                f"link '{link.name}': the mesh of its {body.at.tag} is mirrored by scale "
                f"{spaced(shape.scale)}",
                "mirror the mesh file itself",
                group_key="mirrored",
                severity=Severity.INFO,
            )


def _fix(attribute: Attribute) -> Fix | None:
    """The same numbers without their signs."""
    return fix_value(attribute, " ".join(part.lstrip("-") for part in attribute.value.split()))

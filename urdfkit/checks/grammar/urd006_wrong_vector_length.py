"""A vector has too many or too few numbers.

`xyz`, `rpy`, `size` and `scale` take three, `rgba` four: a mesh scale of one number is refused,
too. urdfdom (RViz, MoveIt, Gazebo, Pinocchio) rejects the robot if it happens in a joint, drops all
shapes of the link if it happens in a visual or collision, and paints a colour black. MuJoCo and
Drake refuse the file.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.grammar import owner
from urdfkit.text.schema import LENGTHS, RGBA

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <visual>
    <geometry><mesh filename="meshes/base.stl" scale="0.001"/></geometry>
    <material name="red"><color rgba="1 0 0"/></material>
  </visual>
</link>"""
GOOD = BAD.replace('"0.001"', '"0.001 0.001 0.001"').replace('"1 0 0"', '"1 0 0 1"')
FIXED = GOOD
FILES = {"meshes/base.stl": PLATE}


@rule(
    "URD006",
    "wrong-vector-length",
    Severity.ERROR,
    help="write as many numbers as it takes, with spaces between them",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for element, attribute, kind, _ in subject.deviations.get("URD006", ()):
        assert attribute is not None
        name, parts = attribute.name, attribute.value.split()
        count = f"{len(parts)} number{'s' if len(parts) != 1 else ''}"
        bound = f"{LENGTHS[kind]} ({kind})"
        title, edits = "", None
        if better := _completed(name, kind, parts):
            title, edits = f'write {name}="{better}"', replace_value(attribute, better)
        yield Finding(
            attribute,
            f"{owner(element)}: {name} of <{element.tag}> has {count}, not {bound}",
            title,
            Fix.of(title, edits),
        )


def _completed(name: str, kind: str, parts: list[str]) -> str | None:
    """The vector that was meant, where there is but one: a scale for all axes, an opaque colour."""
    if name == "scale" and len(parts) == 1:
        return " ".join(parts * 3)
    return " ".join([*parts, "1"]) if kind == RGBA and len(parts) == 3 else None

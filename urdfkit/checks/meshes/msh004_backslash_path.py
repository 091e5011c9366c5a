"""A mesh reference has backslashes.

Only Windows takes a backslash for the end of a folder's name. RViz, Gazebo and every other reader
on Linux look for one file whose name has backslashes in it, and find none. Write `/`, which
Windows understands as well.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = r"""
<link name="arm">
  <visual>
    <geometry><mesh filename="package://arm_description/meshes\forearm.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("\\", "/")
FIXED = GOOD
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}


@rule(
    "MSH004",
    "backslash-path",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="write / instead",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh in subject.files.meshes:
        if "\\" not in mesh.at.value:
            continue
        reference = mesh.at.value.replace("\\", "/")
        edits = replace_value(mesh.literal, reference) if mesh.literal else None
        fix = Fix.of("write / instead of backslashes", edits)
        yield Finding(mesh.at, f"{mesh.who} has backslashes: Linux does not find it", fix=fix)

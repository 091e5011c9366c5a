"""A mesh reference differs from the file's name in upper and lower case.

The file is found on Windows and on most Macs, and missing on Linux, where nearly every robot runs:
in RViz and Gazebo, and in continuous integration. Write the name as it is on disk.

Sources:
    git, core.ignoreCase: https://git-scm.com/docs/git-config
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

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="package://arm_description/Meshes/forearm.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("Meshes", "meshes")
FIXED = GOOD
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}


@rule(
    "MSH002",
    "case-mismatch",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="write the name as it is on disk",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh in subject.files.missing:
        spelt = subject.files.spelt_on_disk(mesh)
        if spelt is None:
            continue
        message = f"{mesh.who} is called '{spelt.reference}' on disk: Linux does not find it"
        edits = replace_value(mesh.literal, spelt.reference) if mesh.literal else None
        fix = Fix.of("write the name as on disk", edits)
        yield Finding(mesh.at, message, fix=fix)

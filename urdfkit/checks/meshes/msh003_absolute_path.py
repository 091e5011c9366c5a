"""A mesh is named by an absolute path.

The path is that of one machine: on every other one, in a container and in continuous integration,
the mesh is missing. Refer to it by its package: `package://my_robot/meshes/arm.stl`. In a xacro,
`file://$(find my_robot)/meshes/arm.stl` is fine, too, since each machine puts its own path there.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="file:///home/student/arm_description/meshes/forearm.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("file:///home/student/arm_description", "package://arm_description")
FIXED = GOOD
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}

_WRITTEN_ABSOLUTE = re.compile(
    r"(?:file://(?:localhost)?|file:(?!//))?(?:/(?!/*\$)|[A-Za-z]:[/\\])"
)


@rule(
    "MSH003",
    "absolute-path",
    Severity.WARNING,
    needs=(Need.MODEL, Need.FILES),
    help="refer to it as package://PACKAGE/...",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    files = subject.files
    for mesh in files.meshes:
        at = mesh.at.at
        path = mesh.located.path
        if path is None or mesh.located.scheme != "absolute" or not isinstance(at, Attribute):
            continue
        if not _WRITTEN_ABSOLUTE.match(at.span.text):  # $(find pkg) made it absolute
            continue
        reference = files.reference_to(path, mesh.located)
        known = reference.startswith("package://")
        edits = replace_value(mesh.literal, reference) if mesh.literal and known else None
        fix = Fix.of(f"refer to {reference}", edits)
        yield Finding(
            mesh.at, f"{mesh.who} is an absolute path of this machine", fix=fix, alike="absolute"
        )

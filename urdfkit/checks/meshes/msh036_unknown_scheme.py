"""A mesh reference begins with a scheme that no reader knows.

`package://`, `model://` and `file://` lead to files. A misspelt one, or one in capitals, leads
nowhere: RViz and Gazebo write "could not load resource" and draw nothing. Meshes on the web, which
RViz alone fetches, are left alone.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="packge://arm_description/meshes/forearm.stl"/></geometry>
  </visual>
</link>"""
FIXED = GOOD = BAD.replace("packge", "package")
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}

_KNOWN = ("package", "model", "file")
#: Fetched by some readers, and not by urdfkit.
_REMOTE = ("http", "https", "ftp", "fuel")


@rule(
    "MSH036",
    "unknown-scheme",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="write package://PACKAGE/path",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh in subject.files.meshes:
        scheme, colon, rest = mesh.at.value.partition("://")
        if not colon or scheme in _KNOWN or scheme.lower() in _REMOTE or "\\" in scheme:
            continue
        suggested = nearest(scheme.lower(), _KNOWN)
        edits = (
            replace_value(mesh.literal, f"{suggested}://{rest}")
            if suggested and mesh.literal
            else None
        )
        yield Finding(
            mesh.at,
            f"{mesh.who} begins with '{scheme}://', which no reader knows",
            f"did you mean '{suggested}://'?" if suggested else "",
            Fix.of(f"write {suggested}://", edits),
        )

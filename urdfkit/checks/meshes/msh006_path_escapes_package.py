"""A mesh reference leaves its package with `..`.

It works in the source tree, where the packages lie side by side. After a build every package is
installed in a folder of its own, and the file beside it is another one or none. Refer to the
package that holds the file: `package://other_package/meshes/arm.stl`.

Sources:
    REP 122, installed files: https://ros.org/reps/rep-0122.html
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.assets.mesh_files import MeshReference

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="package://arm_description/../hand/hand.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("arm_description/../hand/hand", "arm_description/meshes/hand")
FILES = {
    "arm_description/package.xml": b"<package><name>arm_description</name></package>",
    "arm_description/meshes/hand.stl": PLATE,
    "hand/hand.stl": PLATE,
}


@rule(
    "MSH006",
    "path-escapes-package",
    Severity.WARNING,
    needs=(Need.MODEL, Need.FILES),
    help="refer to the package that holds the file",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh in subject.files.meshes:
        package = _left(subject, mesh)
        if package:
            assert mesh.located.path
            message = f"{mesh.who} leaves package '{package}': it is not found once installed"
            home = subject.resolver.packages.enclosing(mesh.located.path)
            yield Finding(mesh.at, message, f"write package://{home[0]}/..." if home else "")


def _left(subject: Subject, mesh: MeshReference) -> str | None:
    """The package that a reference starts in and leaves."""
    located = mesh.located
    if located.path is None or ".." not in located.relative:
        return None
    if located.package:
        left = posixpath.normpath(located.relative).startswith("../")
        return located.package if left else None
    package = subject.resolver.packages.enclosing(subject.files.top)
    if package is None or subject.resolver.packages.enclosing(located.path) == package:
        return None
    return package[0]

"""The package of a mesh reference is not found on this machine.

Without it, the meshes cannot be checked, and no program can load them here: an error, or a warning
if `package.xml` declares the package or ROS has it, since only this machine then lacks it. There is
one finding for all references to the package. If the package is installed elsewhere, pass its
directory or source the workspace that has it; if the name is misspelt, correct it.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    ros2/demos#353: https://github.com/ros2/demos/issues/353
"""

from __future__ import annotations

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.assets.mesh_files import MeshReference, is_typo
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value
from urdfkit.workspace.manifest import is_known_dependency

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="package:///arm_description/meshes/forearm.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("package:///", "package://")
FIXED = GOOD
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="pass its directory with --package NAME=DIR, or source the workspace that has it",
)
def check(subject: Subject) -> Findings:
    for name, meshes in subject.files.without_package.items():
        if name:
            yield _not_found(subject, name, meshes)
            continue
        for mesh in meshes:
            yield _not_named(subject, mesh)


def _not_found(subject: Subject, name: str, meshes: list[MeshReference]) -> Finding:
    first = meshes[0]
    held = "1 mesh" if len(meshes) == 1 else f"{len(meshes)} meshes"
    searched = ", ".join(first.located.searched)
    known = subject.resolver.packages.known(subject.source.path)
    suggested = did_you_mean(name, [package for package in known if is_typo(name, package)])
    is_known = is_known_dependency(name, first.at.span.source.path, subject.resolver)
    return Finding(
        first.at,
        f"link '{first.link}': package '{name}' is not found on this machine, so {held} of it "
        f"cannot be checked; searched {searched}",
        f"pass its directory with --package {name}=DIR, or source the workspace that has it"
        f"{suggested}",
        severity=Severity.WARNING if is_known else None,
    )


def _not_named(subject: Subject, mesh: MeshReference) -> Finding:
    """``package:///name/...``, whose package is the empty text before the third slash."""
    reference = f"{mesh.located.scheme}://{mesh.located.relative.lstrip('/')}"
    located = subject.resolver.locate(reference, subject.files.top)
    edits = replace_value(mesh.literal, reference) if mesh.literal and located.path else None
    fix = Fix.of("remove the third slash", edits)
    scheme = mesh.located.scheme
    message = f"{mesh.who} names no package between '{scheme}://' and the next '/'"
    return Finding(mesh.at, message, f"write {scheme}://PACKAGE/...", fix, alike=scheme)

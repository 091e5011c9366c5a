"""A mesh is found on one machine only.

An absolute path is valid on one machine: on other machines, in a container and in continuous
integration, the mesh is missing. Refer to it by its package: `package://my_robot/meshes/arm.stl`.
In a xacro, `file://$(find my_robot)/meshes/arm.stl` is fine as well, since each machine inserts its
own path.

A reference that leaves its package with `..` works in the source tree, where the packages are side
by side. A build installs each package in a separate directory, where the path refers to another
file or to none. Refer to the package that contains the file.

ROS on Linux finds a path with characters outside ASCII, but PyBullet does not, nor do other
programs on Windows; archives and file systems encode the same letter in two ways, and only one
matches.

A mesh file that git ignores is missing in every clone of the repository. Most often a pattern for
the output of compilers, such as `*.obj`, or for large files, matches it. `git add -f` adds the
file; a line such as `!meshes/*.obj` in .gitignore is a lasting exception.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    bulletphysics/bullet3#3000: https://github.com/bulletphysics/bullet3/issues/3000
    drfenixion/freecad.robotcad#58, in Gazebo: https://github.com/drfenixion/freecad.robotcad/issues/58
    Unicode in file names: https://git-scm.com/docs/git-config#Documentation/git-config.txt-coreprecomposeUnicode
    gitignore: https://git-scm.com/docs/gitignore
    REP 122, installed files: https://ros.org/reps/rep-0122.html
"""

import posixpath
import re

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.samples import mesh_xml
from urdfkit.text.document import Attribute
from urdfkit.text.editing.edits import fix_value

BAD = mesh_xml("visual", "file:///home/student/arm_description/meshes/forearm.stl")
FIXED = GOOD = BAD.replace("file:///home/student/arm_description", "package://arm_description")
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}

_WRITTEN_ABSOLUTE = r"(?:file://(?:localhost)?|file:(?!//))?(?:/(?!/*\$)|[A-Za-z]:[/\\])"


@rule(Severity.WARNING, needs=(Need.MODEL, Need.FILES), help="refer to it as package://PACKAGE/...")
def check(context: Context) -> Findings:
    for mesh in context.files.meshes:
        path = mesh.located.path or mesh.located.outside
        if path is None:
            continue
        if _is_absolute(mesh):
            reference = context.files.reference_to(path, mesh.located)
            known = reference.startswith("package://")
            fix = fix_value(mesh.literal, reference) if mesh.literal and known else None
            message = f"{mesh.who} is an absolute path, which exists on this machine only"
            yield Finding(mesh.at, message, fix=fix, group_key="absolute")
        if isinstance(mesh.at.at, Attribute) and not mesh.at.at.span.text.isascii():
            message = f"{mesh.who} has characters outside ASCII in its path, which is not portable"
            yield Finding(mesh.at, message, "rename the file", group_key="ascii")
        if package := _left(context, mesh, path):
            message = f"{mesh.who} leaves package '{package}': not found once installed"
            home = context.resolver.packages.enclosing(path)
            yield Finding(mesh.at, message, f"write package://{home[0]}/..." if home else "")
    for mesh in context.files.ignored:
        message = f"{mesh.who} is ignored by git: clones of the repository lack it"
        yield Finding(mesh.at, message, "git add -f FILE, and an exception in .gitignore")


def _is_absolute(mesh: MeshReference) -> bool:
    """True for a path that is absolute in the source, not one that begins with $(find pkg)."""
    at = mesh.at.at
    return (
        mesh.located.scheme == "absolute"
        and isinstance(at, Attribute)
        and bool(re.match(_WRITTEN_ABSOLUTE, at.span.text))
    )


def _left(context: Context, mesh: MeshReference, path: str) -> str | None:
    """The package that a reference leaves; None if it does not leave its package."""
    located = mesh.located
    if ".." not in located.relative:
        return None
    if located.package:
        left = posixpath.normpath(located.relative).startswith("../")
        return located.package if left else None
    packages = context.resolver.packages
    package = packages.enclosing(context.files.top)
    return package[0] if package and packages.enclosing(path) != package else None

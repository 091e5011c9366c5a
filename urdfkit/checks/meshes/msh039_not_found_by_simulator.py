"""MuJoCo, PyBullet or Genesis does not find a mesh that ROS finds.

Reported if one of them is a target. The URDF of a xacro is assumed to be next to it.

MuJoCo reads the name of a mesh as a path relative to the URDF, or to `meshdir`: it does not resolve
packages, and rejects a robot with `package://arm_description/meshes/arm.stl` ("Error opening
file"). Visuals are reported only with `<mujoco><compiler discardvisual="false"/></mujoco>`. If all
meshes are in one directory, declare it for MuJoCo in a block that ROS ignores:
`<mujoco><compiler meshdir="../meshes" strippath="true"/></mujoco>`. Otherwise give MuJoCo a copy
of the URDF with relative names (`urdfkit bundle --for mujoco`).

PyBullet removes `package://` and searches for the remaining path in the directory of the URDF and
in all its parent directories. It finds `package://arm_description/meshes/arm.stl` only if one of
them contains a directory `arm_description`, as `src` of a workspace does, and otherwise rejects the
robot, for a visual as well. Genesis searches the directory of the URDF, and a directory above it
that has the name of the package: it finds the meshes of the package of the URDF, not of others.

Sources:
    MuJoCo, meshdir and strippath: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler-strippath
    MuJoCo, xml_urdf.cc: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_urdf.cc
    google-deepmind/mujoco#273: https://github.com/google-deepmind/mujoco/issues/273
    PyBullet, UrdfFindMeshFile.h: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/UrdfFindMeshFile.h
    Genesis, get_filename: https://github.com/Genesis-Embodied-AI/Genesis/blob/main/genesis/ext/urdfpy/utils.py
"""

import os
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.samples import mesh_xml
from urdfkit.ros.targets import TargetFacts
from urdfkit.text.editing.edits import escaped, insert_first
from urdfkit.text.source import shown

#: Where a program searches, by whether it searches all directories above the URDF.
_PLACES = {
    True: "the directories from that of the URDF upwards",
    False: "the directory and in the package of the URDF",
}

NAME = "urdf/arm.urdf"
TARGETS = ("mujoco",)
_ARM = mesh_xml("collision", "package://arm_description/meshes/arm.stl")
BAD = f'<robot name="arm">\n  {_ARM}\n</robot>\n'
FIXED = GOOD = BAD.replace(
    "\n", '\n  <mujoco>\n    <compiler meshdir="../meshes" strippath="true"/>\n  </mujoco>\n', 1
)
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/arm.stl": stl(box((0, 0, 0), (1, 1, 1))),
}


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="give MuJoCo a copy of the URDF with names relative to it, as in ../meshes/arm.stl",
)
def check(context: Context) -> Findings:
    if context.is_part:
        return
    for target in context.given_facts:
        if target.searches_above or target.searches_own_package:
            yield from _not_above(context, target)
        elif not target.finds_packages:
            yield from _of_mujoco(context)


def _not_above(context: Context, target: TargetFacts) -> Findings:
    """Finding about meshes that a target does not find from the directories above the URDF."""
    lost = [mesh for mesh in context.files.meshes if _is_not_above(context, mesh, target)]
    if lost:
        first = lost[0]
        yield Finding(
            first.at,
            f"{first.who} is not found by {target.title}, which looks for "
            f"'{_without_scheme(first.at.value)}' in {_PLACES[target.searches_above]}"
            f"{more_like_this(len(lost) - 1)}",
            f"give {target.title} a copy with relative names: urdfkit bundle --for {target.name}",
            targets=(target.name,),
        )


def _is_not_above(context: Context, mesh: MeshReference, target: TargetFacts) -> bool:
    """True for a mesh that is not found from the directories that a target searches."""
    if mesh.located.path is None or mesh.located.package is None:
        return False  # MSH001
    name = _without_scheme(mesh.at.value)
    for directory in _searched(os.path.abspath(context.source.path), name, target):
        path = os.path.join(directory, name)
        if context.resolver.admits(path) and disk.is_file(path):
            return False
    return True


def _searched(urdf: str, name: str, target: TargetFacts) -> Iterator[str]:
    """The directories in which a target looks for the name of a mesh without its scheme."""
    directory, is_first = urdf, True
    while directory != (directory := os.path.dirname(directory)):
        above, last = os.path.split(directory)
        if is_first or target.searches_above:
            yield directory
        if target.searches_own_package and last == name.partition("/")[0]:
            yield above
        is_first = False


def _without_scheme(name: str) -> str:
    return name.partition("://")[2] or name


def _of_mujoco(context: Context) -> Findings:
    wanted = [
        mesh
        for mesh in context.files.meshes
        if mesh.role == "collision" or not context.mujoco.drops_visuals
    ]
    yield from _outside(context)
    lost = [mesh for mesh in wanted if _is_lost(context, mesh)]
    if lost:
        first = lost[0]
        directory, name = context.mujoco.mesh_path(first.at.value, context.source.path)
        message = f"{first.who} is not found by MuJoCo, which looks for '{name}' in "
        message += f"{shown(os.path.normpath(directory))}{more_like_this(len(lost) - 1)}"
        help, fix = _directory(context, wanted)
        yield Finding(first.at, message, help, fix, targets=("mujoco",))


def _outside(context: Context) -> Findings:
    """Finding about a meshdir outside of the repository, which other machines do not have."""
    block = context.document.root.child("mujoco")
    element = block.child("compiler") if block else None
    written = element.attributes.get("meshdir") if element else None
    directory = os.path.dirname(context.mujoco.mesh_path("a", context.source.path)[0] + os.sep)
    if written is not None and not context.resolver.admits(os.path.join(directory, "a")):
        yield Finding(
            written,
            f"meshdir '{written.value}' leads out of the repository: no other machine has it",
            "name a directory of the repository, relative to the URDF",
            severity=Severity.WARNING,
        )


def _is_lost(context: Context, mesh: MeshReference) -> bool:
    """True for a mesh that only MuJoCo does not find, within the readable directories."""
    located = mesh.located
    if located.path is None and (located.package is None or located.directory is not None):
        return False  # MSH001
    path = os.path.join(*context.mujoco.mesh_path(mesh.at.value, context.source.path))
    return context.resolver.admits(path) and not disk.is_file(path)


def _directory(context: Context, wanted: list[MeshReference]) -> tuple[str, Fix | None]:
    """Help and fix for the directory of all meshes, if it is the same; else empty and None."""
    root = context.document.root
    directories = {os.path.dirname(mesh.located.path or "") for mesh in wanted}
    if len(directories) > 1 or directories == {""} or root.child("mujoco"):
        return "", None
    urdf = os.path.dirname(os.path.abspath(context.source.path))
    directory = os.path.relpath(directories.pop(), urdf).replace(os.sep, "/")
    element = f'<compiler meshdir="{escaped(directory)}" strippath="true"/>'
    fix = None
    if context.reading.xacro is None:
        edits = insert_first(root, ("<mujoco>", f"  {element}", "</mujoco>"))
        fix = Fix("declare the mesh directory for MuJoCo", edits)
    return f"write <mujoco>{element}</mujoco> into <robot>", fix

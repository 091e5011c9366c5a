"""MuJoCo does not find a mesh that ROS finds.

MuJoCo takes the name of a mesh for a path relative to the URDF, or to `meshdir`: it knows no
packages, and rejects a robot with `package://arm_description/meshes/arm.stl` ("Error opening
file"). Reported where MuJoCo is a target, for collisions; for visuals only with
`<mujoco><compiler discardvisual="false"/></mujoco>`. A xacro's URDF is taken to lie next to it.

If all meshes lie in one directory, name it to MuJoCo, which ROS does not read:
`<mujoco><compiler meshdir="../meshes" strippath="true"/></mujoco>`. Otherwise give MuJoCo a copy
of the URDF with relative names.

Sources:
    MuJoCo, meshdir and strippath: https://mujoco.readthedocs.io/en/stable/XMLreference.html#compiler-strippath
    MuJoCo, xml_urdf.cc: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_urdf.cc
    google-deepmind/mujoco#273: https://github.com/google-deepmind/mujoco/issues/273
"""

import os

from urdfkit.core import disk
from urdfkit.core.words import more_like_this
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.samples import mesh_xml
from urdfkit.text.editing.edits import insert_first
from urdfkit.text.source import shown

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
    if context.is_part or all(one.finds_packages for one in context.given_facts):
        return
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
        yield Finding(first.at, message, help, fix)


def _outside(context: Context) -> Findings:
    """A meshdir that leads out of the repository, which other machines do not have."""
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
    """True for a mesh that MuJoCo alone does not find, as far as may be looked."""
    located = mesh.located
    if located.path is None and (located.package is None or located.directory is not None):
        return False  # MSH001
    path = os.path.join(*context.mujoco.mesh_path(mesh.at.value, context.source.path))
    return context.resolver.admits(path) and not disk.is_file(path)


def _directory(context: Context, wanted: list[MeshReference]) -> tuple[str, Fix | None]:
    """How to name the directory of all meshes, if they are in one; else nothing."""
    root = context.document.root
    directories = {os.path.dirname(mesh.located.path or "") for mesh in wanted}
    if len(directories) > 1 or directories == {""} or root.child("mujoco"):
        return "", None
    urdf = os.path.dirname(os.path.abspath(context.source.path))
    directory = os.path.relpath(directories.pop(), urdf).replace(os.sep, "/")
    escaped = directory.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    element = f'<compiler meshdir="{escaped}" strippath="true"/>'
    fix = None
    if context.reading.xacro is None:
        edits = insert_first(root, ("<mujoco>", f"  {element}", "</mujoco>"))
        fix = Fix("tell MuJoCo where the meshes are", edits)
    return f"write <mujoco>{element}</mujoco> into <robot>", fix

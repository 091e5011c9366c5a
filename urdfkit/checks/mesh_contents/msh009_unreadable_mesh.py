"""A mesh file cannot be read, or only a part of it.

The file is empty or contains no triangles; it is truncated, for example by an interrupted download;
it is not a mesh: a web page saved instead of the file, a Git LFS pointer because `git lfs pull` was
not run, an image, an archive; or its content is inconsistent: a vertex that is not three finite
numbers, a face of a vertex that does not exist, XML with a wrong end tag. Some programs reject such
a file, others silently load nothing or a part of it, and a physics engine loses a body whose
collision has an infinite vertex. Export or download it again.

It is a warning if only a part is broken, such as an invalid reference or a colour that is not a
number: parts that RViz shows may be missing in Gazebo. `urdfkit mesh convert` writes the readable
parts.

Sources:
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    assimp, ColladaLoader.cpp: https://github.com/assimp/assimp/blob/master/code/AssetLib/Collada/ColladaLoader.cpp
    Git LFS, pointers: https://github.com/git-lfs/git-lfs/blob/main/docs/spec.md
    STL: https://en.wikipedia.org/wiki/STL_(file_format)
"""

from urdfkit.errors import Unavailable
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.io.facts import DefectKind
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.assets.mesh_defects import MeshDefect, losses
from urdfkit.robot.samples import mesh_xml

BAD = mesh_xml("visual", "meshes/comma.stl")
GOOD = BAD.replace("comma", "plate")

FILES = {"meshes/comma.stl": PLATE.replace(b"1 0 0", b"1,0 0,0 0,0"), "meshes/plate.stl": PLATE}

_HELP = {
    DefectKind.NOT_A_MESH: "export it, or get the file itself: the raw link, or git lfs pull",
    DefectKind.TRUNCATED: "download or export the mesh again",
}
_HELP_PARTLY = "export the mesh again, or urdfkit mesh convert FILE -o NEW.dae"


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="export the mesh again, or copy it from where the robot comes from",
    about_files=True,
)
def check(context: Context) -> Findings:
    for mesh in context.files.meshes:
        if mesh.facts is None:
            continue
        if defect := mesh.facts.defect:
            pull = "run git lfs pull" if "Git LFS" in defect.reason else ""
            help = pull or _HELP.get(defect.kind, "")
            if defect.reason.endswith("archive"):
                help = "unpack it, or export the mesh as STL, OBJ or COLLADA"
            severity = Severity.WARNING if pull else None  # only this checkout lacks the file
            message = f"{mesh.who} {defect.reason}"
            yield Finding(mesh.at, message, help, group_key=pull, severity=severity)
        elif mesh.facts.non_finite:
            help = "export the mesh again, or remove the triangle in a mesh editor"
            message = f"{mesh.who} has a vertex that is not finite: {mesh.facts.non_finite}"
            yield Finding(mesh.at, message, help)
    yield from _partly(context)


def _partly(context: Context) -> Findings:
    """Findings about partly readable files; none if meshes are not measured."""
    try:
        measured = context.measured
    except Unavailable:
        return
    for mesh, reason in measured.unmeasured:
        yield Finding(mesh.at, f"{mesh.who} {reason}", _HELP_PARTLY, severity=Severity.WARNING)
    for use in measured.defects.get(MeshDefect.PARTLY_UNREADABLE, ()):
        message = f"{use.who} is partly broken: {'; '.join(losses(use))}"
        yield Finding(use.at, message, _HELP_PARTLY, severity=Severity.WARNING)

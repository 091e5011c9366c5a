"""Triangles of a mesh have no area.

Two vertices of such a triangle coincide, or all three are on a line. These triangles are invisible
and have no normal: collision checks may get undefined contact directions from them, and normals
computed at their vertices are wrong. A few of them have little effect. `urdfkit mesh repair`
removes them.

Sources:
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    measured: 53 of 1 513 public collision meshes
"""

from urdfkit.core.words import counted
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_defects import MeshDefect
from urdfkit.robot.samples import mesh_xml

BAD = mesh_xml("collision", "forearm.stl")
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl([*box((0, 0, 0), (0.1, 0.1, 0.3)), [(0, 0, 0), (0.1, 0, 0), (0.1, 0, 0)]]),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(Severity.INFO, needs=(Need.MODEL, Need.MESHES), help="urdfkit mesh repair FILE")
def check(context: Context) -> Findings:
    for use in context.measured.defects.get(MeshDefect.DEGENERATE, ()):
        measures = use.measures
        yield Finding(
            use.at,
            f"{use.who}: {measures.degenerate} of {counted(measures.triangles, 'triangle')} "
            f"{'has' if measures.degenerate == 1 else 'have'} no area",
            weight=measures.degenerate / measures.triangles,
            group_key="degenerate",
        )

"""An OBJ file names a file of materials that is not there.

The colours and textures of an OBJ stand in a file beside it, which its `mtllib` names. Left out of
a copy or a repository, or called otherwise since, it takes all of them away: RViz and Gazebo draw
the part white or grey and say so in their logs only. Put the file beside the mesh, delete the
`mtllib` line, or give the visual a `<material>` of URDF. Visuals that have one are not reported,
and neither are collisions.

Sources:
    Wavefront OBJ, mtllib: https://paulbourke.net/dataformats/obj/
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="forearm.obj"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("forearm", "hand")
_OBJ = b"""\
mtllib {}
v 0 0 0
v 0.1 0 0
v 0 0.1 0
v 0 0 0.1
usemtl red
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""
FILES = {
    "forearm.obj": _OBJ.replace(b"{}", b"forearm.mtl"),
    "hand.obj": _OBJ.replace(b"{}", b"hand.mtl"),
    "hand.mtl": b"newmtl red\nKd 1 0 0\n",
}


@rule(
    "MSH037",
    "missing-materials",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="put the file beside the mesh, or give the visual a <material>",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH037", ()):
        name = use.measures.no_materials[0]
        yield Finding(
            use.at,
            f"{use.who} has its colours in '{name}', which is not there",
            alike="materials",
        )

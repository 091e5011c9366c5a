"""A mesh file cannot be read.

It may not be opened, is of no known format, or its content contradicts itself: a corner that is
not three numbers, a face of a vertex that is not there, XML with a wrong end tag, a reference
inside a COLLADA file to nothing. Some readers refuse such a file, others load it in silence as
nothing. Export the mesh again.

Sources:
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.io.facts import DefectKind
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="meshes/comma.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("comma", "plate")

FILES = {
    "meshes/comma.stl": PLATE.replace(b"1 0 0", b"1,0 0,0 0,0"),
    "meshes/plate.stl": PLATE,
}


@rule(
    "MSH009",
    "unreadable-mesh",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="export the mesh again, or copy it from where the robot comes from",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh, reason in subject.files.with_defect(DefectKind.UNREADABLE):
        yield Finding(mesh.at, f"{mesh.who} {reason}")

"""A mesh file holds no triangles.

It has no bytes at all, as `touch` makes it, or it is a frame without content: no facets, no faces,
a scene that shows nothing. Readers either refuse it or load it in silence as nothing, and the
link has no shape. Export the mesh again.

Sources:
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
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
    <geometry><mesh filename="meshes/empty.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("empty", "plate")

FILES = {"meshes/empty.stl": b"", "meshes/plate.stl": PLATE}


@rule(
    "MSH008",
    "empty-mesh",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="export the mesh again, or copy it from where the robot comes from",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh, reason in subject.files.with_defect(DefectKind.EMPTY):
        yield Finding(mesh.at, f"{mesh.who} {reason}")

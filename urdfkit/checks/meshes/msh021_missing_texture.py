"""A mesh uses an image that is not there.

The path of a texture stands in the mesh file or in its .mtl, relative to it. The image was not
copied along, or the path is that of another machine. RViz and Gazebo draw the part white or black
and fill the log with warnings. Put the image beside the mesh, or export the mesh with a plain
colour. Collisions, which nobody sees, are not reported.

Sources:
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
    COLLADA 1.4: https://www.khronos.org/files/collada_spec_1_4.pdf
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import collada
from urdfkit.robot.assets.mesh_diagnoses import missing_textures
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="forearm.dae"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.dae": collada(look='<diffuse><texture texture="image" texcoord="UV"/></diffuse>'),
    "hand.dae": collada(look="<diffuse><color>1 0 0 1</color></diffuse>"),
}


@rule(
    "MSH021",
    "missing-texture",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="put the image beside the mesh, or give the mesh a plain colour",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH021", ()):
        names = missing_textures(use)
        more = f" and {len(names) - 1} more" if len(names) > 1 else ""
        yield Finding(use.at, f"{use.who} uses the image '{names[0]}'{more}, which is not there")

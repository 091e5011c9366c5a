"""A part of a mesh file is broken, and its readers lose more or less of it.

A reference leads to nothing, a number is not one, a list is cut off. What RViz shows may be missing
in Gazebo: trimesh and what builds on it drop a whole geometry over a bad colour, others show it
white, or refuse the file. Export the mesh again, or let `urdfkit mesh convert` write what can be
read.

Sources:
    RViz, assimp_loader.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_rendering/src/rviz_rendering/mesh_loader_helpers/assimp_loader.cpp
    assimp, ColladaLoader.cpp: https://github.com/assimp/assimp/blob/master/code/AssetLib/Collada/ColladaLoader.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import collada
from urdfkit.robot.assets.mesh_diagnoses import losses
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
    "forearm.dae": collada(look="<diffuse><color>0.01.0 0 1</color></diffuse>"),
    "hand.dae": collada(look="<diffuse><color>0.01 0 0 1</color></diffuse>"),
}


@rule(
    "MSH034",
    "mesh-partly-unreadable",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="export the mesh again, or urdfkit mesh convert FILE NEW.dae",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh in subject.measured.unmeasured:
        who = f"link '{mesh.link}': the {mesh.role} mesh '{mesh.at.value}'"
        yield Finding(mesh.at, f"{who} {mesh.reason}")
    for use in subject.measured.diagnoses.get("MSH034", ()):
        yield Finding(use.at, f"{use.who} is broken in parts: {'; '.join(losses(use))}")

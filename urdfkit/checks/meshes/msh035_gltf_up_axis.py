"""A glTF mesh is turned by some programs and not by others.

glTF 2.0 says that y points upwards, and a robot's z does. RViz turns such a mesh by 90 degrees
since its version 15.1.4 (ROS 2 Lyrical); so do Drake, MeshCat and Blender. Gazebo, RViz before
that, assimp and trimesh take the numbers as they are. No file suits both. COLLADA with Z_UP, OBJ
and STL mean the same to all of them: `urdfkit mesh convert hand.glb hand.dae` keeps the numbers,
and with `--upright` turns them as the new RViz does.

Sources:
    glTF 2.0, coordinates: https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html
    ros2/rviz#1482: https://github.com/ros2/rviz/pull/1482
    Gazebo, AssimpLoader.cc: https://github.com/gazebosim/gz-common/blob/main/graphics/src/AssimpLoader.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.io.facts import GLB, GLTF
from urdfkit.mesh.samples import collada, gltf
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="forearm.gltf"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("forearm.gltf", "forearm.dae")
FILES = {"forearm.gltf": gltf(), "forearm.dae": collada("<up_axis>Z_UP</up_axis>")}


@rule(
    "MSH035",
    "gltf-up-axis",
    Severity.INFO,
    needs=(Need.MODEL, Need.FILES),
    help="give the robot COLLADA, OBJ or STL: urdfkit mesh convert [--upright] FILE OUT.dae",
)
def check(subject: Subject) -> Iterator[Finding]:
    found = [
        mesh
        for mesh in subject.files.each_file
        if mesh.facts and not mesh.facts.defect and mesh.facts.format in (GLB, GLTF)
    ]
    if found:
        mesh, *others = found
        more = f" ({len(others)} more of this robot are)" if others else ""
        yield Finding(
            mesh.at,
            f"{mesh.who} is glTF{more}, where y points upwards: RViz from 15.1.4 on and Drake turn "
            "it by 90 degrees, Gazebo and earlier RViz do not",
        )

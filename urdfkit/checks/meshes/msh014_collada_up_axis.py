"""A COLLADA file says that another axis than z points upwards.

RViz, Gazebo, MoveIt, Pinocchio and most Python tools pass over `<up_axis>` and show the mesh as
its numbers are. Bullet, and viewers in the browser, turn it by 90 degrees. If the robot looks right
in RViz, all is well until somebody loads it elsewhere. `urdfkit mesh convert` writes Z_UP, with the
same numbers.

Sources:
    COLLADA 1.4: https://www.khronos.org/files/collada_spec_1_4.pdf
    MoveIt, mesh_operations.cpp: https://github.com/ros-planning/geometric_shapes/blob/ros2/src/mesh_operations.cpp
    PyBullet, COLLADA: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportColladaDemo/LoadMeshFromCollada.cpp
    measured: 213 of 517 public files
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import collada
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
    "forearm.dae": collada("<up_axis>Y_UP</up_axis>"),
    "hand.dae": collada("<up_axis>Z_UP</up_axis>"),
}


@rule(
    "MSH014",
    "collada-up-axis",
    Severity.INFO,
    needs=(Need.MODEL, Need.FILES),
    help="nothing, if it looks right in RViz; urdfkit mesh convert writes Z_UP",
)
def check(subject: Subject) -> Iterator[Finding]:
    turned = [
        (mesh, mesh.facts.up_axis)
        for mesh in subject.files.each_file
        if mesh.facts and mesh.facts.up_axis not in ("", "Z_UP")
    ]
    if turned:
        (mesh, axis), *others = turned
        more = f" ({len(others)} more of this robot say such a thing)" if others else ""
        yield Finding(
            mesh.at,
            f"{mesh.who} says {axis}{more}: Bullet turns it by 90 degrees, RViz, Gazebo, MoveIt "
            "and Pinocchio do not",
        )

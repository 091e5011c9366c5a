"""A mesh file holds more than triangles.

Lines, cameras, lights, bones and animations that a modelling program exports along are not shown by
RViz, and old Gazebo has drawn the lines as thick wire frames. They cost time to load. Export the
selected mesh only, or write the file again with `urdfkit mesh convert`, which keeps the triangles.

Sources:
    COLLADA 1.4: https://www.khronos.org/files/collada_spec_1_4.pdf
    Gazebo Classic, ColladaLoader.cc: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/common/ColladaLoader.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import collada
from urdfkit.robot.assets.mesh_diagnoses import extras
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
    "forearm.dae": collada(
        more="""<lines count="1">
      <input semantic="VERTEX" source="#corners" offset="0"/><p>0 1</p></lines>"""
    ),
    "hand.dae": collada(),
}


@rule(
    "MSH029",
    "collada-extras-ignored",
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="export the mesh alone, or urdfkit mesh convert FILE NEW.dae",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH029", ()):
        message = f"{use.who} also holds {', '.join(extras(use))}; only triangles count"
        yield Finding(use.at, message, alike=", ".join(extras(use)))

"""A visual mesh has very many triangles.

A robot of such parts loads slowly, and RViz and Gazebo draw it slowly on a laptop; a camera in a
simulation does so for every picture. `urdfkit mesh simplify` gives a mesh that looks the same with
far fewer.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_diagnoses import DENSE_VISUAL
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="forearm.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3)), copies=8400),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH020",
    "dense-visual-mesh",
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="urdfkit mesh simplify FILE",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH020", ()):
        number = use.measures.triangles
        yield Finding(
            use.at,
            f"{use.who} has {number} triangles, more than the {DENSE_VISUAL} that are drawn easily",
            weight=number,
            alike="dense",
        )

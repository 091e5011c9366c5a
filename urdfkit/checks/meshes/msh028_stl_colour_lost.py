"""An STL file holds colours, which no reader of URDF shows.

Some CAD programs store a colour in two spare bytes of each triangle, in one of two ways that
contradict each other. RViz, Gazebo and Python tools pass over them; the part is shown in the colour
of its `<material>`, or grey. Give the visual a `<material>`, or export COLLADA.

Sources:
    STL: https://en.wikipedia.org/wiki/STL_(file_format)
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_diagnoses import COLOURS
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
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3)), colour=0x801F),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH028",
    "stl-colour-lost",
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="give the visual a <material>, or export COLLADA",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH028", ()):
        (colours,) = (extra for extra in use.measures.extras if extra.startswith(COLOURS))
        yield Finding(use.at, f"{use.who} holds {colours}, which no reader shows", alike="colours")

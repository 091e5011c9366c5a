"""A link collides with its detailed visual mesh.

Screws and fillets that make a part look good make collision checks slow and contacts noisy. A
simpler shape, such as a box, a cylinder or a convex hull, is faster and behaves better: `urdfkit
mesh collision` proposes one.

Sources:
    gazebosim/sdformat#68: https://github.com/gazebosim/sdformat/issues/68
    measured: 131 of 676 public models
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_diagnoses import DENSE_SHARED
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="forearm.stl"/></geometry>
  </visual>
  <collision>
    <geometry><mesh filename="forearm.stl"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace(
    """  <collision>
    <geometry><mesh filename="forearm.stl"/></geometry>""",
    """  <collision>
    <geometry><box size="0.2 0.2 0.6"/></geometry>""",
)
FILES = {"forearm.stl": stl(500 * box((0, 0, 0), (0.1, 0.1, 0.3)))}


@rule(
    "MSH031",
    "collision-is-the-visual-mesh",
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="urdfkit mesh collision proposes a simple shape",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH031", ()):
        yield Finding(
            use.at,
            f"{use.who} is the visual mesh ({use.measures.triangles:,} triangles, more than "
            f"{DENSE_SHARED:,}); consider a simpler one",
            weight=use.measures.triangles,
            alike="shared",
        )

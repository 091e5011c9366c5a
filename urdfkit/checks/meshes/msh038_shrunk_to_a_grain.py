"""A mesh in metres has a scale for millimetres.

With `scale="0.001 0.001 0.001"` a part of 0.2 m is 0.2 mm long: nobody sees it, and nothing touches
it. The attribute was copied from a mesh that needs it, or the mesh was exported anew in metres. A
mesh is reported if a scale of 0.01 or less makes it shorter than a millimetre.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="forearm.stl" scale="0.001 0.001 0.001"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace(' scale="0.001 0.001 0.001"', "")
FILES = {"forearm.stl": stl(box((0, 0, 0), (0.08, 0.06, 0.3)))}


@rule(
    "MSH038",
    "shrunk-to-a-grain",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="remove the scale, or correct it",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH038", ()):
        whole = use.longest / max(map(abs, use.shape.scale))
        yield Finding(
            use.scale_at or use.at,
            f"{use.who} is {1000 * use.longest:.2g} mm long by its scale, and {whole:.3g} m "
            "without it",
            confidence=Confidence.INFERRED,
            alike="scale",
        )

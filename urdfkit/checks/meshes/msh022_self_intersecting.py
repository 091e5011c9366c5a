"""The pieces of a mesh overlap, and masses computed from it are too large.

Volume, centre of mass and inertia of a mesh are integrals over its surface, and what lies in two
closed pieces at once counts twice: in Gazebo's automatic inertia, in MeshLab, and in
`urdfkit inertia`. An assembly that was exported as one mesh is a common reason. Unite the pieces
where they were drawn or with `urdfkit mesh repair --union`, or state the inertial by hand.

Collisions and pictures do not suffer. Less than a twentieth of the volume is not reported.

Sources:
    Mirtich, Fast and accurate computation of polyhedral mass properties: https://doi.org/10.1080/10867651.1996.10487458
    Gazebo, MeshInertiaCalculator.cc: https://github.com/gazebosim/gz-sim/blob/main/src/MeshInertiaCalculator.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <collision>
    <geometry><mesh filename="forearm.stl"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl([*box((0, 0, 0), (0.1, 0.1, 0.2)), *box((0, 0, 0.1), (0.1, 0.1, 0.3))]),
    "hand.stl": stl([*box((0, 0, 0), (0.1, 0.1, 0.1)), *box((0, 0, 0.15), (0.1, 0.1, 0.3))]),
}


@rule(
    "MSH022",
    "self-intersecting",
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="unite the pieces: urdfkit mesh repair --union FILE",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH022", ()):
        found = use.measures
        yield Finding(
            use.at,
            f"{use.who} has {found.bodies} pieces that overlap: masses computed from it count "
            f"{100 * found.overlap:.0f} % too much",
            alike="overlap",
        )

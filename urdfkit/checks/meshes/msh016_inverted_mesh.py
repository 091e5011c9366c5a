"""A closed mesh, or a piece of one, is turned inside out.

The corners of a triangle are counter-clockwise as seen from outside. In this mesh they are
clockwise: its volume is negative, so that tools which compute a mass from it fail or get a negative
one, MuJoCo refuses it, renderers that draw front sides only show the far inside, and its shading is
wrong. It comes from a mirrored part or from a flip in the export. `urdfkit mesh repair` turns it.

Sources:
    STL: https://en.wikipedia.org/wiki/STL_(file_format)
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import BOX, box, stl
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
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3), (face[::-1] for face in BOX))),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH016",
    "inverted-mesh",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="urdfkit mesh repair FILE",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH016", ()):
        found = use.measures
        what = "its triangles look inwards"
        if found.bodies > 1 and found.inverted_bodies:
            what = f"{found.inverted_bodies} of its {found.bodies} pieces look inwards"
        yield Finding(use.at, f"{use.who} is turned inside out: {what}", alike="inside out")

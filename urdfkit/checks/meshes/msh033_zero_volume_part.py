"""A collision mesh is flat: all of it lies in one plane.

It has no volume. Simulators that take the convex hull of a mesh refuse it (MuJoCo: "volume too
small") or make it a sheet through which fast parts tunnel. Use a thin `<box>`.

Sources:
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
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3), BOX[:2])),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH033",
    "zero-volume-part",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="use a thin <box>",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH033", ()):
        x, y, z = use.edges
        yield Finding(use.at, f"{use.who} is flat: it has {x:.3g} x {y:.3g} x {z:.3g} m")

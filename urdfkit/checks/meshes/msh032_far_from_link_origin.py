"""A mesh lies far away from the link that it belongs to.

The part was exported in the coordinates of the whole assembly, or its `<origin>` is in another
unit. When the joint moves, the mesh swings around the link at a distance; with it go the
collisions, and the picture looks as if the robot had fallen apart. Export the part in its own
coordinates, or correct the `<origin>` of the visual or collision.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_diagnoses import distance
from urdfkit.text.diagnostic import Confidence, Severity

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
    "forearm.stl": stl(box((0, 0, 2), (0.1, 0.1, 2.3))),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH032",
    "far-from-link-origin",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="export the part in its own coordinates, or correct the <origin>",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH032", ()):
        away = distance(use)
        yield Finding(
            use.at,
            f"{use.who} is {use.longest:.3g} m long and begins {away:.3g} m away from the origin "
            "of the link",
            confidence=Confidence.INFERRED,
            weight=away / use.longest,
        )

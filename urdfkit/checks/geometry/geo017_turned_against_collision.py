"""A link is seen turned by a right angle against what is touched.

The bounding boxes of visual and collision have little in common, and would be nearly one if one of
the two were turned about its origin: a mesh whose longest edge is along y beside a cylinder along
z. Often a mesh was exported with other axes, or an `rpy` was written for the visual and forgotten
for the collision. Meshes that programs turn in different ways are left to MSH014 and MSH035.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    measured: no maintained one of 579 public robots has it, but for meshes of glTF.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Confidence, Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><box size="0.5 0.06 0.08"/></geometry>
  </visual>
  <collision>
    <geometry><cylinder radius="0.04" length="0.5"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace("<collision>", '<collision>\n    <origin rpy="0 1.5708 0"/>')


@rule(
    "GEO017",
    "turned-against-collision",
    Severity.WARNING,
    help="look at both in RViz, and turn the one that is wrong",
)
def check(subject: Subject) -> Iterator[Finding]:
    for one in subject.visual_collision_pairs.diagnoses.get("GEO017", ()):
        turn = one.turn
        assert turn is not None
        is_visual = turn.body in one.link.visuals
        role, other = ("visual", "collision") if is_visual else ("collision", "visual")
        others = one.link.collisions if is_visual else one.link.visuals
        rpy = " ".join(f"{round(angle, 4) + 0.0:g}" for angle in turn.rpy)
        yield Finding(
            turn.body.at.child("origin") or turn.body.at,
            f"link '{one.link.name}': the bounding boxes of visual and collision have "
            f'{one.overlap:.0%} of their volume in common; with rpy="{rpy}" for the {role} it '
            f"would be {turn.overlap:.0%}",
            related=(Related(others[0].at.span, f"the {other}"),),
            confidence=Confidence.INFERRED,
            weight=turn.overlap - one.overlap,
        )

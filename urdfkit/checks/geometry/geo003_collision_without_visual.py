"""A link can be touched but is not seen.

It has a `<collision>` and no `<visual>`: RViz and Gazebo show nothing where the robot bumps. For a
bumper zone or a ball that stands for a caster that is right. Otherwise copy the collision's shape
to a `<visual>`.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="caster">
  <collision>
    <geometry><sphere radius="0.02"/></geometry>
  </collision>
</link>"""
GOOD = (
    BAD[: -len("</link>")]
    + """\
  <visual>
    <geometry><sphere radius="0.02"/></geometry>
  </visual>
</link>"""
)


@rule(
    "GEO003",
    "collision-without-visual",
    Severity.INFO,
    help="add a <visual> if the link is to be seen",
)
def check(subject: Subject) -> Iterator[Finding]:
    for link in subject.model.links:
        if link.collisions and not link.visuals:
            message = f"link '{link.name}' has a collision and no visual"
            yield Finding(link.collisions[0].at, message, alike="no visual")

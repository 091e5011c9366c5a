"""The robot has no shape at all.

No link has a visual or a collision: RViz shows frames only, and in a simulation the robot is
neither seen nor touched. For a model of pure kinematics that is right; otherwise the shapes were
lost on the way, for instance in an include that an argument switched off.

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
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="arm"/>
</joint>"""
GOOD = BAD.replace(
    '<link name="arm"/>',
    """<link name="arm">
  <visual>
    <geometry><cylinder radius="0.05" length="0.4"/></geometry>
  </visual>
</link>""",
)


@rule("GEO008", "no-geometry-robot", Severity.INFO, help="give the links visuals and collisions")
def check(subject: Subject) -> Iterator[Finding]:
    links = subject.model.links
    shapeless = not any(link.visuals or link.collisions for link in links)
    if links and shapeless and not subject.is_part:
        count = f"none of the {len(links)} links has" if len(links) > 1 else "the link has"
        either = "a visual or a collision" if len(links) > 1 else "neither visual nor collision"
        yield Finding(subject.model.root, f"{count} {either}")

"""A link is seen but cannot be touched.

It has a `<visual>` and no `<collision>`. In Gazebo it passes through the floor and other objects,
and a lidar that is simulated on the processor looks through it; MoveIt plans right through it. For
a label, a marker or the glass of a lens that is right. Otherwise add a `<collision>` with a simple
shape.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Gazebo Classic, URDF: https://classic.gazebosim.org/tutorials?tut=ros_urdf
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <visual>
    <geometry><box size="0.4 0.3 0.1"/></geometry>
  </visual>
  <collision>
    <geometry><box size="0.4 0.3 0.1"/></geometry>
  </collision>
</link>
<link name="mast">
  <visual>
    <geometry><cylinder radius="0.02" length="0.5"/></geometry>
  </visual>
</link>
<joint name="mast_mount" type="fixed">
  <parent link="base"/>
  <child link="mast"/>
</joint>"""
GOOD = BAD.replace(
    """length="0.5"/></geometry>
  </visual>""",
    """length="0.5"/></geometry>
  </visual>
  <collision>
    <geometry><cylinder radius="0.02" length="0.5"/></geometry>
  </collision>""",
)


@rule(
    "GEO002",
    "visual-without-collision",
    Severity.INFO,
    help="add a <collision> with a simple shape if the link can be touched",
    by_target={"moveit": Severity.WARNING},
)
def check(subject: Subject) -> Iterator[Finding]:
    links = [link for link in subject.model.links if link.visuals]
    if len(links) > 1 and not any(link.collisions for link in subject.model.links):
        message = f"none of the {len(links)} links with a visual has a collision"
        yield Finding(subject.model.root, message)
        return
    for link in links:
        if not link.collisions:
            yield Finding(
                link.visuals[0].at,
                f"link '{link.name}' has a visual and no collision",
                alike="no collision",
            )

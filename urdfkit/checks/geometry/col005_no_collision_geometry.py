"""A part at the end of a chain moves and has mass, but no shape at all.

Neither it nor what is fixed to it has a `<visual>` or a `<collision>`, and nothing hangs on it:
forces act on it, but nobody sees it, and nothing can touch it. Other links of the robot have
collision geometry, so this one was forgotten, or it is a stand-in for a mechanism and may stay as
it is.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Gazebo Classic, URDF: https://classic.gazebosim.org/tutorials?tut=ros_urdf
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.rigid_bodies import RigidBody, rigid_bodies
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <collision><geometry><box size="0.4 0.3 0.1"/></geometry></collision>
</link>
<link name="pendulum">
  <inertial>
    <origin xyz="0 0 -0.2"/>
    <mass value="0.5"/>
    <inertia ixx="2e-3" ixy="0" ixz="0" iyy="2e-3" iyz="0" izz="1e-4"/>
  </inertial>
</link>
<joint name="pivot" type="continuous">
  <parent link="base"/>
  <child link="pendulum"/>
  <axis xyz="0 1 0"/>
</joint>"""
GOOD = BAD.replace(
    "</inertial>",
    """</inertial>
  <collision>
    <origin xyz="0 0 -0.2"/>
    <geometry><sphere radius="0.04"/></geometry>
  </collision>""",
)

#: In kg: less is a number that a simulator asked for.
_HEAVY = 1e-3


@rule(
    "COL005",
    "no-collision-geometry",
    Severity.INFO,
    help="add <visual> and <collision>, if the part exists",
)
def check(subject: Subject) -> Iterator[Finding]:
    if not any(link.collisions for link in subject.model.links) or subject.is_part:
        return
    for body in rigid_bodies(subject.tree):
        if body.joint and body.mass > _HEAVY and _is_bare_end(body, subject):
            yield Finding(
                body.top.at,
                f"link '{body.top.name}' moves, weighs {body.mass:g} kg, and has no shape",
            )


def _is_bare_end(body: RigidBody, subject: Subject) -> bool:
    links = [link for link, _ in body.links]
    hanging = sum(len(subject.tree.children[link.name]) for link in links)
    return hanging == len(links) - 1 and not any(link.visuals or link.collisions for link in links)

"""A link has a visual and no collision.

In Gazebo it passes through the floor and other objects, and a lidar that is simulated on the
processor looks through it; MoveIt plans right through it. For a label, a marker or the glass of a
lens that is right. Otherwise add a `<collision>` with a simple shape. It is a warning for a caster
or wheel without which a robot on wheels does not stand: in a simulation the robot tips over.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    Gazebo Classic, URDF: https://classic.gazebosim.org/tutorials?tut=ros_urdf
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.stability import is_freestanding, stand
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.stability import Stability

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
    bare = [link for link in links if not link.collisions]
    needed = _needed(subject) if bare else ()
    for link in bare:
        supports = link.name in needed
        yield Finding(
            link.visuals[0].at,
            f"link '{link.name}' has a visual and no collision"
            + ("; without it the robot does not stand" if supports else ""),
            help="add a <collision> with the shape that touches the ground" if supports else "",
            alike="no support" if supports else "no collision",
            severity=Severity.WARNING if supports else None,
        )


def _needed(subject: Subject) -> tuple[str, ...]:
    """The links that a robot on wheels stands on, as it looks, if those with collision do not do.

    Nothing is known where its meshes cannot be read.
    """
    wheeled = any(joint.kind == "continuous" for joint in subject.model.joints)
    if not wheeled or subject.is_part or not subject.tree.is_sound:
        return ()
    links = subject.model.links_by_name
    try:
        looks = stand(subject, visuals=True)
        if looks is None or looks.tips or not is_freestanding(subject.tree, looks.links):
            return ()
        touching = [name for name in looks.links if links[name].collisions]
        found = stand(subject, contacts=touching)
        return () if _holds(found) or _lacks_meshes(subject) else looks.links
    except ImportError:
        return ()


def _holds(found: Stability | None) -> bool:
    return found is not None and not found.tips


def _lacks_meshes(subject: Subject) -> bool:
    """True if a collision may reach the ground in a mesh that cannot be read."""
    return any(
        body.shape and body.shape.filename and subject.meshes.mesh(body.shape) is None
        for link in subject.model.links
        for body in link.collisions
    )

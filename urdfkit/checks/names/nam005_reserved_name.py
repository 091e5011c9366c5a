"""A name is kept for something else.

In SDF `world` is the world itself, and names in double underscores belong to the format. Gazebo
therefore never makes a link called `world`: as the empty root that fixes the robot to the ground it
is right, but its mass and shapes are lost, and as the child of a joint it makes Gazebo and MuJoCo
refuse the robot.

Sources:
    sdformat, Utils.cc: https://github.com/gazebosim/sdformat/blob/main/src/Utils.cc
    MuJoCo, xml_urdf.cc: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Link

BAD = """\
<link name="world">
  <inertial>
    <mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.02"/>
  </inertial>
</link>"""
GOOD = BAD.replace("world", "base")


@rule(
    "NAM005",
    "reserved-name",
    Severity.INFO,
    help="choose another name",
    by_target=dict.fromkeys((*GAZEBO, "mujoco"), Severity.WARNING),
)
def check(subject: Subject) -> Iterator[Finding]:
    model = subject.model
    children = {joint.child.value for joint in model.joints if joint.child}
    for at in model.names:
        tag, name = at.element.tag, at.value
        if len(name) > 4 and name.startswith("__") and name.endswith("__"):
            reason = "names in double underscores belong to Gazebo's SDF"
        elif name != "world":
            continue
        elif tag == "joint":
            reason = "in Gazebo's SDF this is the name of the world"
        elif name in children:
            reason = "Gazebo and MuJoCo take it for the world, which no joint can move"
        elif _has_body(model.links_by_name[name]):
            reason = "Gazebo takes it for the world and drops its mass and shapes"
        else:
            continue
        yield Finding(at, f"{tag} '{name}': {reason}")


def _has_body(link: Link) -> bool:
    return bool(link.inertial or link.visuals or link.collisions)

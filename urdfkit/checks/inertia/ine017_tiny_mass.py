"""A link that a joint moves has a mass so small that Gazebo takes it for none.

Up to sdformat 9.10.0 and 12.7.1 a mass of up to 1e-6 kg counts as none: Gazebo leaves out the link
and everything that hangs on it. Such a mass is meant to be "nothing"; a moving link cannot have
that. Give it a gram, or make its joint fixed.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/sdformat#199: https://github.com/gazebosim/sdformat/issues/199
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.rigid_bodies import NO_MASS
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="2"/>
    <inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
  </inertial>
</link>
<link name="finger_tip">
  <inertial>
    <mass value="1e-10"/>
    <inertia ixx="1e-10" ixy="0" ixz="0" iyy="1e-10" iyz="0" izz="1e-10"/>
  </inertial>
</link>
<joint name="finger" type="prismatic">
  <parent link="base"/>
  <child link="finger_tip"/>
  <limit lower="0" upper="0.1" effort="10" velocity="1"/>
</joint>"""
GOOD = BAD.replace('"1e-10"', '"0.001"')


@rule(
    "INE017",
    "tiny-mass",
    Severity.INFO,
    help="give it a gram, or make its joint fixed",
    by_target=dict.fromkeys(("classic-ros1", "classic-ros2", "gz-fortress"), Severity.WARNING),
)
def check(subject: Subject) -> Iterator[Finding]:
    for body in subject.masses.bodies:
        if body.joint is None or not 0 < body.mass <= NO_MASS:
            continue
        link = body.top
        mass = link.inertial.mass if link.inertial else None
        yield Finding(
            mass or link.at,
            f"link '{link.name}' weighs {body.mass:.3g} kg and is moved by the {body.joint.kind} "
            f"joint '{body.joint.name}'; up to {NO_MASS:g} kg older Gazebo leaves it out",
        )

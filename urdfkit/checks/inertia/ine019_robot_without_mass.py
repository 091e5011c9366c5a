"""No link of the robot has a mass.

For RViz, MoveIt and everything else that only asks where the links are, this is all right: many
arms are published like this. Gazebo leaves out every link and then refuses the robot, since a model
must have one. Before a simulation, give the links an `<inertial>`.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/sdformat#199: https://github.com/gazebosim/sdformat/issues/199
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="arm">
  <visual>
    <geometry><cylinder radius="0.05" length="0.4"/></geometry>
  </visual>
</link>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="arm"/>
</joint>"""
GOOD = BAD.replace(
    "</visual>",
    """</visual>
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.014" ixy="0" ixz="0" iyy="0.014" iyz="0" izz="0.00125"/>
  </inertial>""",
)


@rule(
    "INE019",
    "robot-without-mass",
    Severity.INFO,
    help="for a simulation, give every link that moves an <inertial>",
    by_target=dict.fromkeys(GAZEBO, Severity.ERROR),
)
def check(subject: Subject) -> Iterator[Finding]:
    links = subject.model.links
    if links and subject.masses.total == 0 and not subject.is_part:
        yield Finding(
            subject.model.root,
            "the link has no mass"
            if len(links) == 1
            else f"none of the {len(links)} links has a mass",
        )

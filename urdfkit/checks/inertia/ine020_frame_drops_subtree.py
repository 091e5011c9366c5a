"""A joint hangs on a link without mass that is fixed to another link.

Gazebo makes a link that is fixed to its parent a part of it. Up to sdformat 9.10.0 and 12.7.1, if
such a link has no mass, everything that hangs on it by a moving joint is left out without a word:
the wheel on a bracket, the arm on a mounting plate. Let the joint hang on the parent, with both
origins added up, or give the link a mass of a gram and a small tensor.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    gazebosim/sdformat#199: https://github.com/gazebosim/sdformat/issues/199
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.gazebo.conversion import OLD, Conversion
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
<link name="plate"/>
<link name="arm">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.014" ixy="0" ixz="0" iyy="0.014" iyz="0" izz="0.0012"/>
  </inertial>
</link>
<joint name="mount" type="fixed">
  <parent link="base"/>
  <child link="plate"/>
</joint>
<joint name="shoulder" type="continuous">
  <parent link="plate"/>
  <child link="arm"/>
</joint>"""
GOOD = BAD.replace('<parent link="plate"/>', '<parent link="base"/>')


@rule(
    "INE020",
    "frame-drops-subtree",
    Severity.INFO,
    help="let the joint hang on the parent, or give the link a mass of a gram",
    by_target=dict.fromkeys(("classic-ros1", "classic-ros2", "gz-fortress"), Severity.WARNING),
)
def check(subject: Subject) -> Iterator[Finding]:
    for body in Conversion(subject.tree, OLD).stranded:
        joint = body.joint
        assert joint is not None
        assert joint.parent is not None
        yield Finding(
            joint.at,
            f"joint '{joint.name}' hangs on link '{joint.parent.value}', which has no mass and is "
            f"fixed to another link: older Gazebo leaves out '{body.top.name}' and what is on it",
        )

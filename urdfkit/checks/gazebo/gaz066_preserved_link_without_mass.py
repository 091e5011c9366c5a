"""A fixed joint is to be kept in Gazebo, and the link behind it has no mass.

`<preserveFixedJoint>` saves a link from being merged, and a link without mass is dropped all the
same: the joint and the link are both absent, with whatever hangs on them. Frames such as optical
frames need no link in Gazebo; a link that a sensor or plugin needs must weigh something.

Sources:
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    measured: libsdformat 12.3 drops link and joint
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.robot.rigid_bodies import KEEPING_TAGS
from urdfkit.ros.gazebo.values import is_true
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="tip"/>
<joint name="mount" type="fixed">
  <parent link="base"/>
  <child link="tip"/>
</joint>
<gazebo reference="mount">
  <preserveFixedJoint>true</preserveFixedJoint>
</gazebo>"""
GOOD = BAD.replace(
    '<link name="tip"/>',
    """<link name="tip">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>""",
)


@rule(
    "GAZ066",
    "preserved-link-without-mass",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    help="give the link an <inertial>, or remove the tag",
)
def check(subject: Subject) -> Iterator[Finding]:
    massless = {body.top.name for body in subject.gazebo.massless}
    for block in subject.model.gazebo:
        joint = subject.model.joints_by_name.get(block.get("reference") or "")
        if joint is None or joint.kind != "fixed" or joint.child is None:
            continue
        for tag in block.children:
            if tag.tag in KEEPING_TAGS and is_true(tag) and joint.child.value in massless:
                link = joint.child.value
                message = f"joint '{joint.name}' is kept, and its link '{link}' has no mass"
                yield Finding(tag, f"{message}: Gazebo leaves out both")

"""A joint mimics another one with multiplier 0, and never moves.

Whatever the leader does, the follower stays at its offset. Write the multiplier, make the joint
fixed, or leave the attribute out, which means 1.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="palm"/>
<link name="left"/>
<link name="right"/>
<joint name="left_joint" type="revolute">
  <parent link="palm"/>
  <child link="left"/>
  <axis xyz="0 0 1"/>
  <limit lower="0" upper="1" effort="10" velocity="1"/>
</joint>
<joint name="right_joint" type="revolute">
  <parent link="palm"/>
  <child link="right"/>
  <axis xyz="0 0 -1"/>
  <limit lower="0" upper="1" effort="10" velocity="1"/>
  <mimic joint="left_joint" multiplier="0"/>
</joint>"""
GOOD = BAD.replace(' multiplier="0"', "")


@rule("JNT036", "mimic-without-effect", Severity.WARNING, help="write the multiplier, such as 1")
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        if joint.mimic and joint.mimic.joint and joint.mimic.multiplier == 0:
            yield Finding(
                joint.mimic.at.attributes.get("multiplier", joint.mimic.at),
                f"joint '{joint.name}' follows '{joint.mimic.joint.value}' times 0: it stays at "
                f"{joint.mimic.offset:g}",
            )

"""A fixed joint has an axis.

It has no effect: nothing moves, and readers do not even look at it. It is left over from a joint
that once moved, or the joint should not be fixed. Remove it.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    measured: in 143 of 676 public models
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import remove_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="camera"/>
<joint name="camera_joint" type="fixed">
  <parent link="base"/>
  <child link="camera"/>
  <axis xyz="0 1 0"/>
</joint>"""
GOOD = BAD.replace('  <axis xyz="0 1 0"/>\n', "")
FIXED = GOOD


@rule(
    "JNT020",
    "axis-on-fixed",
    Severity.INFO,
    help="remove the axis",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for joint in subject.model.joints:
        axis = joint.at.child("axis")
        if joint.kind == "fixed" and axis is not None:
            edits = remove_element(axis)
            yield Finding(
                axis,
                f"joint '{joint.name}' is fixed; its axis has no effect",
                fix=Fix("remove the axis", edits, safe=True),
                alike="axis",
            )

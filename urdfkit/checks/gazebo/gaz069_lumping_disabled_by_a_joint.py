"""A fixed joint is kept by a tag that makes it a joint that turns.

`<disableFixedJointLumping>` is older than `<preserveFixedJoint>`: Gazebo makes a revolute joint of
it, with limits of 0 and 0, which the solver holds by force. Under load it gives way, and it costs
time in every step. The newer tag keeps the joint fixed, and wins where both stand.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    gazebosim/sdformat#131: https://github.com/gazebosim/sdformat/issues/131
    robotology/icub-models#25: https://github.com/robotology/icub-models/issues/25
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.gazebo.values import is_true
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rename_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="tool"/>
<joint name="wrist" type="fixed">
  <parent link="base"/>
  <child link="tool"/>
</joint>
<gazebo reference="wrist">
  <disableFixedJointLumping>true</disableFixedJointLumping>
</gazebo>"""
FIXED = GOOD = BAD.replace("disableFixedJointLumping", "preserveFixedJoint")


@rule(
    "GAZ069",
    "lumping-disabled-by-a-joint",
    Severity.INFO,
    help="write <preserveFixedJoint>",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    joints = subject.model.joints_by_name
    blocks = [one for one in subject.model.gazebo if (one.get("reference") or "") in joints]
    kept = {
        block.get("reference")
        for block in blocks
        if any(map(is_true, block.all("preserveFixedJoint")))
    }
    for block in blocks:
        joint = joints[block.get("reference") or ""]
        for tag in block.all("disableFixedJointLumping"):
            if joint.kind == "fixed" and is_true(tag) and joint.name not in kept:
                edits = rename_element(tag, "preserveFixedJoint")
                yield Finding(
                    tag,
                    f"joint '{joint.name}' becomes a revolute joint in Gazebo, which gives way "
                    "under load",
                    fix=Fix.of("write <preserveFixedJoint>", edits),
                    alike="lumping",
                )

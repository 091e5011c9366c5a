"""A tag for a joint stands in the block of a link, or the other way round.

Gazebo's converter applies `mu1`, `kp`, `selfCollide` and their like to links, and
`preserveFixedJoint`, `provideFeedback`, `springStiffness` and their like to joints; in the block of
the other kind they do nothing, and neither does `preserveFixedJoint` for a joint that is not fixed.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.catalog.extensions import extensions
from urdfkit.diagnostic import Severity
from urdfkit.document import Element
from urdfkit.rules import Finding, rule

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="camera"/>
<joint name="camera_joint" type="fixed">
  <parent link="base"/>
  <child link="camera"/>
</joint>
<gazebo reference="camera">
  <preserveFixedJoint>true</preserveFixedJoint>
</gazebo>"""
GOOD = BAD.replace('reference="camera"', 'reference="camera_joint"')

_FIXED_ONLY = ("preserveFixedJoint", "disableFixedJointLumping")


@rule("GAZ005", "tag-on-wrong-kind", Severity.WARNING)
def check(subject: Subject) -> Iterator[Finding]:
    model = subject.model
    handled = extensions()
    for block in model.gazebo:
        name = block.get("reference") or ""
        is_link, joint = name in model.links_by_name, model.joints_by_name.get(name)
        if is_link == (joint is not None):  # both or neither, which other rules tell
            continue
        kind = "link" if is_link else "joint"
        for child in block.children:
            extension = handled.get(child.tag)
            if extension and extension.on in ("link", "joint") and extension.on != kind:
                message = (
                    f"<{child.tag}> is for a {extension.on}, and '{name}' is a {kind}: Gazebo "
                    "ignores it"
                )
                yield Finding(child, message, _remedy(subject, name, kind, child))
            elif joint and child.tag in _FIXED_ONLY and joint.kind not in ("fixed", ""):
                message = f"<{child.tag}> has no effect: joint '{name}' is {joint.kind}, not fixed"
                yield Finding(child, message, "remove it, or name the fixed joint that is meant")


def _remedy(subject: Subject, name: str, kind: str, child: Element) -> str:
    """The block in which the tag belongs."""
    if kind == "link":
        above = subject.tree.parents.get(name, [])
        other = above[0].name if len(above) == 1 else "..."
    else:
        below = subject.model.joints_by_name[name].child
        other = below.value if below else "..."
    return f'move <{child.tag}> into <gazebo reference="{other}">'

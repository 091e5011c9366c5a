"""A tag for a joint stands in the block of a link, or the other way round.

Gazebo's converter applies `mu1`, `kp`, `selfCollide` and their like to links, and
`preserveFixedJoint`, `provideFeedback`, `springStiffness` and their like to joints; in the block of
the other kind they do nothing, and neither does `preserveFixedJoint` for a joint that is not fixed.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.model import Joint
from urdfkit.robot.rigid_bodies import KEEPING_TAGS
from urdfkit.ros.catalog.extensions import extensions
from urdfkit.text.diagnostic import Edit, Fix, Severity
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import STEP, insert_after, lines_of, remove_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import Link

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
FIXED = GOOD


@rule("GAZ005", "tag-on-wrong-kind", Severity.WARNING, fixable=True)
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
                message = f"<{child.tag}> is for a {extension.on}, and '{name}' is a {kind}: Gazebo"
                other = _other(subject, name, kind)
                help = f'move it into <gazebo reference="{other.name if other else "..."}">'
                fix = _moved(block, child, other) if other else None
                yield Finding(child, f"{message} ignores it", help, fix, alike=child.tag)
            elif joint and child.tag in KEEPING_TAGS and joint.kind not in ("fixed", ""):
                message = f"<{child.tag}> has no effect: joint '{name}' is {joint.kind}, not fixed"
                help = "remove it, or name the fixed joint that is meant"
                yield Finding(child, message, help, alike=child.tag)


def _other(subject: Subject, name: str, kind: str) -> Link | Joint | None:
    """The joint above a link, if there is one alone; the link below a joint."""
    model = subject.model
    if kind == "link":
        above = subject.tree.parents.get(name, [])
        return above[0] if len(above) == 1 else None
    below = model.joints_by_name[name].child
    return model.links_by_name.get(below.value) if below else None


def _moved(block: Element, child: Element, other: Link | Joint) -> Fix | None:
    """Another reference for a block that holds nothing else, else a block of its own."""
    name, reference = other.at.attributes.get("name"), block.attributes["reference"]
    is_same_macro = other.at.frame is block.frame is child.frame  # where expressions mean the same
    if name is None or name.written_in or reference.written_in or not is_same_macro:
        return None
    if isinstance(other, Joint) and child.tag in KEEPING_TAGS and other.kind != "fixed":
        return None
    title = f'move it into <gazebo reference="{other.name}">'
    if len(block.children) == 1:
        return Fix(title, (Edit(reference.span, name.span.text),))
    lines = (
        f'<gazebo reference="{name.span.text}">',
        *(STEP + line for line in lines_of(child)),
        "</gazebo>",
    )
    return Fix(title, (*remove_element(child), *insert_after(block, lines)))

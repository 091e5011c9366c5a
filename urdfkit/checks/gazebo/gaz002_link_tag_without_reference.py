"""A tag for a link or a joint stands in a `<gazebo>` block without a reference.

The content of such a block belongs to the whole model, and a model has no friction, material or
sensor of its own: Gazebo's converter stores them and never uses them, without a message. Write one
block per link, with `reference="..."`.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.extensions import copied, extensions
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.model import RobotModel
    from urdfkit.text.document import Element

BAD = """\
<link name="wheel">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <mu1>0.8</mu1>
</gazebo>"""
GOOD = BAD.replace("<gazebo>", '<gazebo reference="wheel">')


#: Tags of a block that a message names.
_NAMED = 4


@rule("GAZ002", "link-tag-without-reference", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    owners = {
        tag: extension.on
        for tag, extension in extensions().items()
        if extension.on in ("link", "joint")
    }
    of_model = set(copied("model"))
    for kind in ("joint", "link"):
        owners.update((tag, kind) for tag in copied(kind) if tag not in of_model)
    for block in subject.model.gazebo:
        if block.get("reference"):
            continue
        if mistake := _mistake(subject.model, block):
            yield mistake
            continue
        misplaced = [(child, owner) for child in block.children if (owner := owners.get(child.tag))]
        if misplaced:
            yield _finding(block, misplaced)


def _finding(block: Element, misplaced: list[tuple[Element, str]]) -> Finding:
    """At the tag; at the block if it holds several."""
    child, owner = misplaced[0]
    if len(misplaced) == 1:
        what, belongs = f"<{child.tag}>", f"it belongs to a {owner}"
    else:
        names = [f"<{tag}>" for tag in dict.fromkeys(child.tag for child, _ in misplaced)]
        what = ", ".join(names[:_NAMED]) + (" and others" if len(names) > _NAMED else "")
        belongs = f"they belong to a {owner}"
    return Finding(
        block if len(misplaced) > 1 else child,
        f"Gazebo ignores {what} here: {belongs}, and this block refers to none",
        f'write <gazebo reference="...">, with the name of the {owner}',
        alike=child.tag,
    )


def _mistake(model: RobotModel, block: Element) -> Finding | None:
    """An attribute that was meant to be the reference."""
    for attribute in block.attributes.values():
        name, value = attribute.name, attribute.value
        if name != "reference" and (value in model.links_by_name or value in model.joints_by_name):
            message = f'Gazebo does not read {name}="{value}" of <gazebo>, and takes the block'
            return Finding(
                attribute, f"{message} for one without a reference", f'write reference="{value}"'
            )
    return None

"""Gazebo knows no such tag in a `<gazebo>` block.

Gazebo's converter handles some tags by name (`mu1`, `kp`, `material`...) and copies all others into
the SDF, where the simulator warns about what it does not know and goes on without it. `<mu>` for
`<mu1>` and the snake_case names of SDF (`max_vel`, `laser_retro`) are usual slips.

Sources:
    SDFormat extensions to URDF: http://sdformat.org/tutorials?tut=sdformat_urdf_extensions
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.extensions import copied, extensions, suggested
from urdfkit.text.diagnostic import Fix, Related, Severity
from urdfkit.text.editing.edits import rename_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

BAD = """\
<link name="wheel">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="wheel">
  <mu>0.8</mu>
</gazebo>"""
GOOD = BAD.replace("mu>", "mu1>")
FIXED = GOOD


#: Elements of the robot, whose readers look for them in ``<robot>`` alone.
_OF_ROBOT = ("ros2_control", "transmission", "gazebo")


@rule(
    "GAZ003",
    "unknown-tag",
    Severity.WARNING,
    fixable=True,
    help="see the tags of the URDF page of Gazebo's tutorials, or remove it",
)
def check(subject: Subject) -> Iterator[Finding]:
    known = {*extensions(), *(tag for kind in ("link", "joint", "model") for tag in copied(kind))}
    strange: dict[str, list[Element]] = {}
    for block in subject.model.gazebo:
        for child in block.children:
            if child.tag not in known and ":" not in child.tag:  # prefixes are for other programs
                strange.setdefault(child.tag, []).append(child)
    suggester = Suggester(known)
    for tag, elements in strange.items():
        right = suggested().get(tag) or suggester.suggested(tag)
        if right:
            yield from (_mistake(element, right) for element in elements)
        else:
            yield _unknown(tag, elements)


def _unknown(tag: str, elements: list[Element]) -> Finding:
    """One finding for all of a name: one mistake, however often it was copied."""
    count = f" ({len(elements)} times)" if len(elements) > 1 else ""
    others = tuple(Related(one.span, f"<{tag}>") for one in elements[1:5])
    help = f"move <{tag}> out of the <gazebo>, into <robot>" if tag in _OF_ROBOT else ""
    message = f"Gazebo knows no <{tag}>, and ignores it{count}"
    return Finding(elements[0], message, help, related=others)


def _mistake(element: Element, right: str) -> Finding:
    edits = rename_element(element, right)
    return Finding(
        element,
        f"Gazebo knows no <{element.tag}>, and ignores it",
        f"did you mean <{right}>?",
        Fix.of(f"rename it to <{right}>", edits),
    )

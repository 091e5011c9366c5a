"""An element has a name that URDF does not know.

Every reader passes over it without a word, and over all that stands in it. Most often the name is
a slip of the pen, or the tag belongs to another format (SDF, an old ROS tutorial, another
simulator). A tag with a namespace prefix, such as `drake:proximity_properties`, is an extension
and is not reported. Correct the name, or remove the element.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import remove_element, rename_element
from urdfkit.text.grammar import calling_macro, owner

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

BAD = """\
<link name="base">
  <colision>
    <geometry><box size="0.2 0.2 0.1"/></geometry>
  </colision>
</link>"""
GOOD = BAD.replace("colision", "collision")
FIXED = GOOD


@rule(
    "URD001",
    "unknown-element",
    Severity.WARNING,
    help="remove it, or give it the namespace prefix of the program that reads it",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for element, _, _, suggested in subject.deviations.get("URD001", ()):
        assert element.parent is not None
        who = owner(element.parent)
        message = f"{who}: unknown element <{element.tag}> in <{element.parent.tag}> (ignored)"
        yield Finding(
            element,
            f"{message}; did you mean <{suggested}>?" if suggested else message,
            _help(element, suggested),
            _fix(element, suggested),
            alike=f"{element.tag} in {element.parent.tag}",
        )


def _help(element: Element, suggested: str) -> str:
    macro = calling_macro(element)
    if not suggested:
        return ""
    return f"rename it to <{suggested}>" + (f" in the call of macro '{macro}'" if macro else "")


def _fix(element: Element, suggested: str) -> Fix | None:
    """Another name, or nothing in the place of an element that holds nothing."""
    if suggested:
        edits = rename_element(element, suggested)
        fix = Fix.of(f"rename <{element.tag}> to <{suggested}>", edits)
        # What was not read as a block may move the robot once it is.
        return fix._replace(safe=False) if fix and calling_macro(element) else fix
    if element.children or element.text.strip():
        return None  # what somebody wrote there may belong elsewhere
    return Fix(f"remove the <{element.tag}>", remove_element(element))

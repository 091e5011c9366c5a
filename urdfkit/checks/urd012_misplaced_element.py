"""An element of URDF stands where URDF does not have it.

Readers pass over it without a word: a `<material>` inside `<geometry>` gives no colour, an
`<origin>` directly in a link moves nothing, a `<mass>` outside `<inertial>` weighs nothing. Move it
to where it belongs.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Fix, Severity
from urdfkit.document import Element
from urdfkit.edits import move_after
from urdfkit.grammar import owner
from urdfkit.rules import Finding, rule
from urdfkit.schema import places_of

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <visual>
    <geometry>
      <box size="0.4 0.3 0.1"/>
      <material name="blue">
        <color rgba="0 0 1 1"/>
      </material>
    </geometry>
  </visual>
</link>"""
GOOD = """\
<link name="base">
  <visual>
    <geometry>
      <box size="0.4 0.3 0.1"/>
    </geometry>
    <material name="blue">
      <color rgba="0 0 1 1"/>
    </material>
  </visual>
</link>"""
FIXED = GOOD


@rule("URD012", "misplaced-element", Severity.WARNING, fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    for element, *_ in subject.deviations.get("URD012", ()):
        assert element.parent is not None
        places = " or ".join(f"<{place}>" for place in sorted(places_of(element.tag)))
        yield Finding(
            element,
            f"{owner(element.parent)}: readers pass over the <{element.tag}> in "
            f"<{element.parent.tag}>; it belongs in {places}",
            f"move it into {places}",
            _moved(element, element.parent),
        )


def _moved(element: Element, parent: Element) -> Fix | None:
    """The move that is surely meant: a material out of the geometry, into its visual."""
    visual = parent.parent
    if element.tag != "material" or parent.tag != "geometry" or visual is None:
        return None
    if visual.tag != "visual" or visual.child("material") or len(parent.all("material")) > 1:
        return None
    edits = move_after(element, parent)
    return Fix("move the <material> out of the <geometry>", edits) if edits else None

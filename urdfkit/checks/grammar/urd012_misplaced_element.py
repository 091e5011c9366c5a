"""An element of URDF stands where URDF does not have it.

Readers pass over it without a word: a `<material>` inside `<geometry>` gives no colour, an
`<origin>` directly in a link moves nothing, a `<mass>` outside `<inertial>` weighs nothing. Move it
to where it belongs.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    urdf-usd-converter, benchmarks: so in 74 of 408 public models: https://github.com/newton-physics/urdf-usd-converter
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.text.diagnostic import Fix, Related, Severity
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import move_after
from urdfkit.text.grammar import owner
from urdfkit.text.schema import places_of

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

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

#: Elements of one tag in the same wrong place that are shown.
_SHOWN = 5


@rule("URD012", "misplaced-element", Severity.WARNING, fixable=True)
def check(subject: Subject) -> Iterator[Finding]:
    alike: dict[tuple[str, str], list[Element]] = {}
    for element, *_ in subject.deviations.get("URD012", ()):
        assert element.parent is not None
        fix = _moved(element, element.parent)
        if fix is None:
            alike.setdefault((element.tag, element.parent.tag), []).append(element)
        else:
            yield _finding(element, element.parent, fix=fix)
    for first, *others in alike.values():
        assert first.parent is not None
        yield _finding(first, first.parent, others)


def _finding(
    element: Element, parent: Element, others: Sequence[Element] = (), fix: Fix | None = None
) -> Finding:
    """One finding for an element and others of its tag in the same wrong place."""
    places = " or ".join(f"<{place}>" for place in sorted(places_of(element.tag)))
    message = (
        f"{owner(parent)}: URDF parsers ignore <{element.tag}> inside <{parent.tag}>; "
        f"it belongs in {places}"
    )
    if others:
        message += f" (and {len(others)} more like this)"
    related = tuple(Related(other.span, owner(other)) for other in others[:_SHOWN])
    # Nobody looks at a collision.
    is_idle = element.tag == "material" and parent.tag == "collision"
    severity = Severity.INFO if is_idle else None
    return Finding(element, message, f"move it into {places}", fix, related, severity=severity)


def _moved(element: Element, parent: Element) -> Fix | None:
    """The move that is surely meant: a material out of the geometry, into its visual."""
    visual = parent.parent
    if element.tag != "material" or parent.tag != "geometry" or visual is None:
        return None
    if visual.tag != "visual" or visual.child("material") or len(parent.all("material")) > 1:
        return None
    return Fix("move the <material> out of the <geometry>", move_after(element, parent))

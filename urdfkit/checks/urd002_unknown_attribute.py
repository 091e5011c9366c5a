"""An attribute has a name that URDF does not know.

Every reader passes over it and takes the default of the attribute that was meant: a joint with
`velocty="2"` has no velocity limit. Correct the name, or remove the attribute.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Fix, Related, Severity
from urdfkit.editing.edits import rename_attribute
from urdfkit.grammar import owner
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.document import Attribute, Element
    from urdfkit.subject import Subject

BAD = """\
<link name="base"/>
<link name="lid"/>
<joint name="hinge" type="continuous">
  <parent link="base"/>
  <child link="lid"/>
  <dynamics damping="0.1" fricton="0.2"/>
</joint>"""
GOOD = BAD.replace("fricton", "friction")
FIXED = GOOD

#: Elements with the same foreign attribute that are shown.
_SHOWN = 5


@rule(
    "URD002",
    "unknown-attribute",
    Severity.WARNING,
    help="remove it, or give it the namespace prefix of the program that reads it",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    alike: dict[tuple[str, str], list[Attribute]] = {}
    for element, attribute, _, meant in subject.deviations.get("URD002", ()):
        assert attribute is not None
        if meant:
            yield _slip(element, attribute, meant)
        else:
            alike.setdefault((element.tag, attribute.name), []).append(attribute)
    for attributes in alike.values():
        yield _foreign(attributes)


def _slip(element: Element, attribute: Attribute, meant: str) -> Finding:
    """An attribute that is probably a misspelt one."""
    edits = rename_attribute(attribute, meant)
    return Finding(
        attribute,
        f"{owner(element)}: <{element.tag}> has no attribute '{attribute.name}'; "
        f"did you mean '{meant}'?",
        f"rename it to {meant}",
        Fix(f"rename {attribute.name} to {meant}", edits) if edits else None,
    )


def _foreign(attributes: list[Attribute]) -> Finding:
    """An attribute of some other program; one finding for all elements that have it."""
    first, *others = attributes
    element = first.element
    message = f"{owner(element)}: <{element.tag}> has no attribute '{first.name}'"
    if others:
        message += f" (and {len(others)} more that have it)"
    related = tuple(Related(other.span, owner(other.element)) for other in others[:_SHOWN])
    return Finding(first, message, related=related)

"""An element is given twice where parsers read one.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio), Drake and PyBullet read the first and ignore the
second without a message; MuJoCo rejects the file. A `<geometry>` holds one shape, an
`<inertial>` one mass. Remove one of them, or put a second shape into a visual or collision of its
own.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

from __future__ import annotations

from itertools import zip_longest

from urdfkit.lint.rules import Finding, Findings, Fix, Related, Severity, Subject, rule
from urdfkit.robot.samples import collision_xml, link_xml
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import remove_element
from urdfkit.text.grammar import owner
from urdfkit.text.schema import SHAPES

_ORIGIN = '<origin xyz="0 0 0.05"/>'
BAD = link_xml("base", collision_xml('<box size="0.4 0.3 0.1"/>', _ORIGIN, _ORIGIN))
FIXED = GOOD = link_xml("base", collision_xml('<box size="0.4 0.3 0.1"/>', _ORIGIN))


@rule(Severity.WARNING, help="remove one of them")
def check(subject: Subject) -> Findings:
    for element, *_ in subject.deviations.get("URD007", ()):
        assert element.parent is not None
        first = _first(element, element.parent)
        who, place = owner(element.parent), element.parent.tag
        if first.tag == element.tag:
            message = f"{who}: a second <{element.tag}> in <{place}>; parsers read the first"
        else:
            message = f"{who}: <{element.tag}> after <{first.tag}> in one <{place}>; parsers read "
            message += "the first shape"
        related = (Related(first.span, "the first"),)
        yield Finding(
            element,
            message,
            fix=_fix(element, first),
            related=related,
            group_key=f"{element.tag} in {place}",
        )


def _fix(element: Element, first: Element) -> Fix | None:
    """Remove an exact copy of the first."""
    if not _is_same(element, first):
        return None
    return Fix("remove the copy", remove_element(element), safe=True)


def _is_same(one: Element, other: Element) -> bool:
    """True if two elements hold the same, element by element."""
    pairs = zip_longest(one.walk(), other.walk())
    return all(a and b and _content(a) == _content(b) for a, b in pairs)


def _content(element: Element) -> tuple[object, ...]:
    values = {name: attribute.value.split() for name, attribute in element.attributes.items()}
    return (element.tag, values, element.text.strip(), len(element.children))


def _first(element: Element, parent: Element) -> Element:
    """The one that parsers read."""
    alternatives = SHAPES if parent.tag == "geometry" else (element.tag,)
    return next(child for child in parent.children if child.tag in alternatives)

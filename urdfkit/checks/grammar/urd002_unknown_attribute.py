"""An attribute has a name that URDF does not define.

URDF parsers ignore it and use the default of the intended attribute: a joint with `velocty="2"`
has no velocity limit. Correct the name, or remove the attribute.

An attribute that resembles no attribute of URDF and contains no number that URDF uses belongs to
another program, or is a note: an info.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
"""

from urdfkit.core.words import listed, more_like_this
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml
from urdfkit.text import schema
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import rename_attribute
from urdfkit.text.grammar import owner

BAD = robot_xml(
    link_xml("base"),
    link_xml("lid"),
    joint_xml("continuous", '<dynamics damping="0.1" fricton="0.2"/>', name="hinge", child="lid"),
)
FIXED = GOOD = BAD.replace("fricton", "friction")

#: Number of foreign attributes, and of elements with them, that a finding lists.
_MAX_NAMED = 5


@rule(Severity.WARNING, help="remove it, unless a program of yours reads it")
def check(context: Context) -> Findings:
    foreign: dict[tuple[str, bool], list[Attribute]] = {}
    for element, attribute, _, suggested in context.deviations.get("URD002", ()):
        assert attribute is not None
        if suggested:
            yield _mistake(element, attribute, suggested)
        else:
            foreign.setdefault((element.tag, _is_misplaced(attribute)), []).append(attribute)
    for (_, is_misplaced), attributes in foreign.items():
        finding = _foreign(attributes)
        yield finding if is_misplaced else finding._replace(severity=Severity.INFO)


def _mistake(element: Element, attribute: Attribute, suggested: str) -> Finding:
    """An attribute that is probably misspelt."""
    edits = rename_attribute(attribute, suggested)
    return Finding(
        attribute,
        f"{owner(element)}: unknown attribute '{attribute.name}' in <{element.tag}> (ignored); "
        f"did you mean '{suggested}'?",
        f"rename it to {suggested}",
        Fix.of(f"rename {attribute.name} to {suggested}", edits),
        is_about_name=True,
    )


def _is_misplaced(attribute: Attribute) -> bool:
    """True for numbers other than defaults that belong into another element of URDF.

    All other attributes belong to another program, or are notes.
    """
    is_of_urdf = attribute.name in schema.numeric_attributes()
    return is_of_urdf and any(word.strip("+-0.") for word in attribute.value.split())


def _foreign(attributes: list[Attribute]) -> Finding:
    """Attributes of another program; one finding for all elements of a tag that have them."""
    first = attributes[0]
    element = first.element
    names = [f"'{name}'" for name in dict.fromkeys(attribute.name for attribute in attributes)]
    kind = "attributes" if len(names) > 1 else "attribute"
    what = f"unknown {kind} {listed(names, _MAX_NAMED)} in <{element.tag}> (ignored)"
    others = {
        attribute.element: attribute for attribute in attributes if attribute.element is not element
    }
    message = f"{owner(element)}: {what}{more_like_this(len(others))}"
    related = tuple(
        Related(attribute.span, owner(attribute.element))
        for attribute in list(others.values())[:_MAX_NAMED]
    )
    return Finding(first, message, related=related, is_about_name=True)

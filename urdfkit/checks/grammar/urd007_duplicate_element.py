"""An element is written twice where parsers read only one.

urdfdom (RViz, MoveIt, Gazebo, Pinocchio), Drake and PyBullet read the first and ignore the second
without a message. MuJoCo rejects the robot (an error if it is a target), unless it does not read
the element: a `<texture>`, a `<safety_controller>`, a `<calibration>`, the `<limit>` of a fixed
joint. A `<geometry>` contains one shape, an `<inertial>` one mass. Remove one of them, or put a
second shape into a separate visual or collision.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
    MuJoCo, FindSubElem in xml_util.cc: https://github.com/google-deepmind/mujoco/blob/main/src/xml/xml_util.cc
"""

from itertools import zip_longest

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.robot.samples import collision_xml, link_xml
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import remove_element
from urdfkit.text.grammar import owner
from urdfkit.text.schema import SHAPES

#: Elements that MuJoCo does not read: everywhere, and in a fixed joint.
_UNREAD = ("texture", "safety_controller", "calibration")
_UNREAD_IF_FIXED = ("dynamics", "limit", "mimic")

_ORIGIN = '<origin xyz="0 0 0.05"/>'
BAD = link_xml("base", collision_xml('<box size="0.4 0.3 0.1"/>', _ORIGIN, _ORIGIN))
FIXED = GOOD = link_xml("base", collision_xml('<box size="0.4 0.3 0.1"/>', _ORIGIN))


@rule(Severity.WARNING, help="remove one of them")
def check(context: Context) -> Findings:
    rejecting = [target for target in context.given_facts if target.rejects_repeated]
    names = " and ".join(target.title for target in rejecting)
    for element, *_ in context.deviations.get("URD007", ()):
        assert element.parent is not None
        first = _first(element, element.parent)
        is_rejected = bool(rejecting) and _is_read_by_mujoco(element, first)
        who, place = owner(element.parent), element.parent.tag
        if first.tag == element.tag:
            message = f"{who}: a second <{element.tag}> in <{place}>; parsers read the first"
            message += f", {names} rejects it" if is_rejected else ""
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
            severity=Severity.ERROR if is_rejected else None,
            targets=tuple(target.name for target in rejecting) if is_rejected else (),
        )


def _is_read_by_mujoco(element: Element, first: Element) -> bool:
    """True if MuJoCo reads one element of this tag there, and rejects a second one."""
    if element.tag != first.tag or element.tag in _UNREAD:
        return False
    joint = element.parent
    assert joint is not None
    is_fixed = joint.tag == "joint" and joint.get("type") == "fixed"
    return not (is_fixed and element.tag in _UNREAD_IF_FIXED)


def _fix(element: Element, first: Element) -> Fix | None:
    """Remove an exact copy of the first."""
    if not _is_same(element, first):
        return None
    return Fix("remove the copy", remove_element(element), safe=True)


def _is_same(one: Element, other: Element) -> bool:
    """True if two elements have the same content."""
    pairs = zip_longest(one.walk(), other.walk())
    return all(a and b and _content(a) == _content(b) for a, b in pairs)


def _content(element: Element) -> tuple[object, ...]:
    values = {name: attribute.value.split() for name, attribute in element.attributes.items()}
    return (element.tag, values, element.text.strip(), len(element.children))


def _first(element: Element, parent: Element) -> Element:
    """The element that parsers read."""
    alternatives = SHAPES if parent.tag == "geometry" else (element.tag,)
    return next(child for child in parent.children if child.tag in alternatives)

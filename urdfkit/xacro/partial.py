"""The part of a robot that does not need packages which are not found."""

from collections import Counter
from collections.abc import Iterable

from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import Document, Element
from urdfkit.text.source import Source, Span
from urdfkit.xacro import dom
from urdfkit.xacro.dom import Dom
from urdfkit.xacro.errors import FAILED
from urdfkit.xacro.expansion_log import PACKAGE_NOT_FOUND


def without_failed_values(tree: Dom, sources: tuple[Source, ...]) -> Document | None:
    """A document without the parts whose values depend on a package that is not found.

    Those are visuals and collisions with a mesh of the package, and extensions such as a plugin
    with a parameter file of it. None if a link or a joint depends on the package, since its place
    is not known then, and for a part of a robot, which has no name or no link.
    """
    document = dom.to_document(tree, sources)
    root = document.root
    if not root.get("name") or root.child("link") is None or _has_failed(root):
        return None
    for child in list(root.children):
        failed = [element for element in child.walk() if _has_failed(element)]
        if failed and child.tag not in ("link", "joint"):
            root.children.remove(child)
            continue
        for element in failed:
            shape = _shape(element)
            if shape is None:
                return None
            if shape in child.children:
                child.children.remove(shape)
    return document


def lacks_no_link(tree: Dom, known: Document, problems: Iterable[Problem]) -> bool:
    """True if the packages are only named in shapes, and in blocks for Gazebo.

    A macro, a property or an include that names one may hide any part.
    """
    kinds = Counter(child.tag for child in dom.to_document(tree, ()).root.children)
    kinds.subtract(child.tag for child in known.root.children)
    places = (
        span
        for problem in problems
        if problem.code == PACKAGE_NOT_FOUND
        for span in (problem.span, *(other.span for other in problem.related))
    )
    return set(+kinds) <= {"gazebo"} and not any(map(_is_of_xacro, places))


def _is_of_xacro(span: Span) -> bool:
    """True for a place in a tag of xacro, or in the text behind one."""
    data = span.source.data
    return data.startswith(b"<xacro:", data.rfind(b"<", 0, span.start + 1))


def _has_failed(element: Element) -> bool:
    return FAILED in (element.text or "") or any(
        FAILED in attribute.value for attribute in element.attributes.values()
    )


def _shape(element: Element) -> Element | None:
    """The visual or collision of a mesh."""
    above = element
    while above.parent is not None and above.tag not in ("visual", "collision"):
        above = above.parent
    return above if element.tag == "mesh" and above.parent is not None else None

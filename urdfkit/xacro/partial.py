"""The part of a robot that does not need packages which are not found."""

from urdfkit.text.document import Document, Element
from urdfkit.text.source import Source
from urdfkit.xacro import dom
from urdfkit.xacro.dom import Dom
from urdfkit.xacro.errors import FAILED


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

"""Source locations as JSON, for ``urdfkit expand --map``, and elements by their address."""

from collections.abc import Iterable
from typing import Any

from urdfkit.core.suggest import did_you_mean, hint_for
from urdfkit.errors import UrdfkitError
from urdfkit.text.document import Attribute, Document, Element, Step
from urdfkit.text.source import Span

VERSION = 1


class NoSuchElement(UrdfkitError):
    """No element or attribute has the address."""


def place_map(document: Document) -> dict[str, Any]:
    """Source location of every element of a document, and the calls that led there.

    Returns:
        ``{"version", "elements": [{"element", "path", "line", "column", "literal", "via"}]}``, in
        document order; ``literal`` lists the attributes whose text in the file is their value.
    """
    return {"version": VERSION, "elements": list(map(_element, document.root.walk()))}


def _element(element: Element) -> dict[str, Any]:
    return {
        "element": element.path,
        **_place(element.span),
        "literal": [name for name, a in element.attributes.items() if a.literal],
        "via": [_step(step) for step in element.via],
    }


def _step(step: Step) -> dict[str, Any]:
    return {"kind": step.kind, "name": step.name, **_place(step.span)}


def _place(span: Span) -> dict[str, Any]:
    line, column = span.source.position(span.start)
    return {"path": span.source.path, "line": line, "column": column}


def find(document: Document, address: str) -> Element | Attribute:
    """The element or attribute at an address such as ``link/arm/inertial/inertia@ixx``.

    Raises:
        NoSuchElement: the message contains the nearest address.
    """
    path, at, name = address.partition("@")
    elements = {element.path: element for element in reversed(list(document.root.walk()))}
    element = elements.get(path.strip("/"))
    if element is None:
        raise NoSuchElement(f"no element '{path}'{_hint(path, elements)}")
    if not at:
        return element
    attribute = element.attributes.get(name)
    if attribute is None:
        names = did_you_mean(name, element.attributes)
        raise NoSuchElement(f"element '{path}' has no attribute '{name}'{names}")
    return attribute


def _hint(path: str, elements: Iterable[str]) -> str:
    """The nearest address; that of the link or joint if it is a name alone."""
    kinds = ("link/", "joint/")
    whole = (one for one in elements if one.startswith(kinds) and one.endswith(f"/{path}"))
    return hint_for(next(whole, None)) or did_you_mean(path, elements)

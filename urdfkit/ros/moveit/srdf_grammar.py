"""Deviations of an SRDF file from its grammar, ``catalog/srdf.json``.

Other programs store tags of their own in the same file, so an unknown name is reported only if it
is a typo of a known name.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.core.suggest import TYPO, nearest
from urdfkit.ros.catalog import data
from urdfkit.text.document import Attribute, Element


class SrdfDeviation(Record):
    """An invalid tag or attribute, and the suggested name."""

    at: Element | Attribute
    parent: Element
    name: str
    suggested: str


class _Grammar(Record):
    """Attributes and children of an element; ``!`` follows required attributes."""

    attributes: tuple[str, ...]
    children: tuple[str, ...]

    @property
    def names(self) -> list[str]:
        return [word.rstrip("!") for word in self.attributes]


def _elements(root: Element) -> Iterator[tuple[Element, _Grammar]]:
    """The known elements, outer elements first."""
    tags = data("srdf")["tags"]
    stack = [root]
    while stack:
        element = stack.pop()
        path = f"{element.parent.tag if element.parent else ''}/{element.tag}"
        entry = tags.get(path) or tags[element.tag]
        grammar = _Grammar(*(tuple(entry[key].split()) for key in _Grammar._fields))
        yield element, grammar
        stack += [child for child in reversed(element.children) if child.tag in grammar.children]


def misspelt_names(root: Element) -> Iterator[SrdfDeviation]:
    """The misspelt tags and attributes of a file."""
    for element, grammar in _elements(root):
        for child in element.children:
            if child.tag not in grammar.children and ":" not in child.tag:
                suggested = nearest(child.tag, grammar.children, TYPO)
                if suggested:
                    yield SrdfDeviation(child, element, child.tag, suggested)
        names = grammar.names
        for attribute in element.attributes.values():
            if attribute.name not in names and ":" not in attribute.name:
                suggested = nearest(attribute.name, names, TYPO)
                if suggested and element.get(suggested) is None:
                    yield SrdfDeviation(attribute, element, attribute.name, suggested)


def missing_attributes(root: Element) -> Iterator[tuple[Element, str]]:
    """Elements without a required attribute, and the attribute.

    Typos are ignored, and so are empty values of expressions, which may be arguments of the user.
    """
    misspelt = {(id(mistake.parent), mistake.suggested) for mistake in misspelt_names(root)}
    for element, grammar in _elements(root):
        for word in grammar.attributes:
            name = word.rstrip("!")
            written = element.attributes.get(name)
            is_empty = written is None or (not written.value and written.literal)
            if name != word and is_empty and (id(element), name) not in misspelt:
                yield element, name

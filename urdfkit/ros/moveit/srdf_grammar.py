"""What of an SRDF file deviates from its grammar, ``catalog/srdf.json``.

Other programs keep tags of their own in the same file, so an unknown name is reported only where it
is a typo of a known one.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.core.suggest import TYPO, nearest
from urdfkit.ros.catalog import data
from urdfkit.text.document import Attribute, Element


class SrdfDeviation(Record):
    """A tag or attribute that SRDF does not have, and the suggested one."""

    at: Element | Attribute
    parent: Element
    name: str
    suggested: str


class _Grammar(Record):
    """What an element has; ``!`` stands behind the attributes that it must have."""

    attributes: tuple[str, ...]
    children: tuple[str, ...]

    @property
    def names(self) -> list[str]:
        return [word.rstrip("!") for word in self.attributes]


def _elements(root: Element) -> Iterator[tuple[Element, _Grammar]]:
    """The elements that SRDF knows, outer ones first."""
    tags = data("srdf")["tags"]
    stack = [root]
    while stack:
        element = stack.pop()
        path = f"{element.parent.tag if element.parent else ''}/{element.tag}"
        entry = tags.get(path) or tags[element.tag]
        grammar = _Grammar(*(tuple(entry[key].split()) for key in _Grammar._fields))
        yield element, grammar
        stack += [child for child in reversed(element.children) if child.tag in grammar.children]


def mistakes(root: Element) -> Iterator[SrdfDeviation]:
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


def lacking(root: Element) -> Iterator[tuple[Element, str]]:
    """The elements without an attribute that they need, each with the attribute.

    Typos are left out, and empty values of expressions: they may be arguments that users pass.
    """
    misspelt = {(id(mistake.parent), mistake.suggested) for mistake in mistakes(root)}
    for element, grammar in _elements(root):
        for word in grammar.attributes:
            name = word.rstrip("!")
            given = element.attributes.get(name)
            is_empty = given is None or (not given.value and given.literal)
            if name != word and is_empty and (id(element), name) not in misspelt:
                yield element, name

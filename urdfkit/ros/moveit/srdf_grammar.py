"""The grammar of SRDF as data, and what of a file deviates from it.

Source: srdfdom's parser (``src/model.cpp``). Other programs keep tags of their own in the same
file, so an unknown name is reported only where it is a typo of a known one.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.core.suggest import TYPO, nearest

if TYPE_CHECKING:
    from urdfkit.text.document import Attribute, Element


class ElementGrammar(Record):
    """What an element has; ``text`` of ``children`` are tags, of the others attributes."""

    required: tuple[str, ...] = ()
    optional: tuple[str, ...] = ()
    children: tuple[str, ...] = ()


class SrdfDeviation(Record):
    """A tag or attribute that SRDF does not have, and the suggested one."""

    at: Element | Attribute
    parent: Element
    name: str
    suggested: str


#: By tag; ``joint`` of a state has a value, too.
KINDS = {
    "robot": ElementGrammar(
        ("name",),
        ("version",),
        tuple(
            "group group_state end_effector virtual_joint passive_joint disable_collisions "
            "enable_collisions disable_default_collisions link_sphere_approximation "
            "joint_property".split()
        ),
    ),
    "group": ElementGrammar(("name",), (), ("link", "joint", "chain", "group")),
    "link": ElementGrammar(("name",)),
    "joint": ElementGrammar(("name",)),
    "chain": ElementGrammar(("base_link", "tip_link")),
    "group_state": ElementGrammar(("name", "group"), (), ("joint",)),
    "end_effector": ElementGrammar(("name", "group", "parent_link"), ("parent_group",)),
    "virtual_joint": ElementGrammar(("name", "type", "parent_frame", "child_link")),
    "passive_joint": ElementGrammar(("name",)),
    "disable_collisions": ElementGrammar(("link1", "link2"), ("reason",)),
    "enable_collisions": ElementGrammar(("link1", "link2"), ("reason",)),
    "disable_default_collisions": ElementGrammar(("link",)),
    "link_sphere_approximation": ElementGrammar(("link",), (), ("sphere",)),
    "sphere": ElementGrammar(("center", "radius")),
    "joint_property": ElementGrammar(("joint_name", "property_name", "value")),
}
_STATE_JOINT = ElementGrammar(("name", "value"))


def _elements(root: Element) -> Iterator[tuple[Element, ElementGrammar]]:
    """The elements that SRDF knows, outer ones first."""
    stack = [root]
    while stack:
        element = stack.pop()
        kind = KINDS[element.tag]
        if element.tag == "joint" and element.parent and element.parent.tag == "group_state":
            kind = _STATE_JOINT
        yield element, kind
        stack += [child for child in reversed(element.children) if child.tag in kind.children]


def mistakes(root: Element) -> Iterator[SrdfDeviation]:
    """The misspelt tags and attributes of a file."""
    for element, kind in _elements(root):
        for child in element.children:
            if child.tag not in kind.children and ":" not in child.tag:
                suggested = nearest(child.tag, kind.children, TYPO)
                if suggested:
                    yield SrdfDeviation(child, element, child.tag, suggested)
        names = (*kind.required, *kind.optional)
        for attribute in element.attributes.values():
            if attribute.name not in names and ":" not in attribute.name:
                suggested = nearest(attribute.name, names, TYPO)
                if suggested and element.get(suggested) is None:
                    yield SrdfDeviation(attribute, element, attribute.name, suggested)


def lacking(root: Element) -> Iterator[tuple[Element, str]]:
    """The elements without an attribute that they need, each with the attribute.

    Typos are left out.
    """
    misspelt = {(id(mistake.parent), mistake.suggested) for mistake in mistakes(root)}
    for element, kind in _elements(root):
        for name in kind.required:
            if not element.get(name) and (id(element), name) not in misspelt:
                yield element, name

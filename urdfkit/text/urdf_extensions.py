"""Elements and attributes that a program adds to URDF without a namespace prefix."""

import os
from functools import cache

from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import nearest
from urdfkit.text.document import Element
from urdfkit.text.schema import TEXT, AttributeRule, Grammar

_TYPO = 0.85


@cache
def _data() -> dict[str, Any]:
    from json import load  # most models need no facts

    path = os.path.join(os.path.dirname(__file__), "urdf_extensions.json")
    with open(path, encoding="utf-8") as file:
        facts: dict[str, Any] = load(file)
    return facts


def _extensions() -> list[dict[str, Any]]:
    extensions: list[dict[str, Any]] = _data()["extensions"]
    return extensions


@cache
def _read(kind: str) -> frozenset[tuple[str, str]]:
    """Pairs of a tag and an element or attribute that a program reads in it."""
    return frozenset(
        (extension["in"], name) for extension in _extensions() for name in extension.get(kind, ())
    )


def has_element(parent: str, tag: str) -> bool:
    """True if a known program reads an element in another one, such as ``contact`` in a link."""
    return (parent, tag) in _read("elements")


def has_attribute(tag: str, name: str) -> bool:
    """True if a known program reads an attribute, such as ``concave`` of a collision."""
    return (tag, name) in _read("attributes")


@cache
def elements_in(parent: str) -> frozenset[str]:
    """The elements that programs read in another one."""
    return frozenset(tag for place, tag in _read("elements") if place == parent)


@cache
def attributes_of(tag: str) -> frozenset[str]:
    """The attributes that programs read in an element."""
    return frozenset(name for place, name in _read("attributes") if place == tag)


def intended_of_drake(written: str, kind: str = "elements") -> str:
    """What a misspelt or former element or attribute of Drake should be; empty for others."""
    prefix, _, name = written.partition(":")
    if prefix != "drake":
        return ""
    facts = _data()["drake"]
    known = facts[kind].split()
    if name in known:
        return ""
    intended = facts["former"].get(name) or nearest(name, known, _TYPO)
    return f"drake:{intended}" if intended else ""


def place_of(element: Element) -> str:
    """Where a program reads an element that stands elsewhere; empty if no program is known.

    That is ``mujoco`` for a ``compiler`` in the robot, and the robot for a ``mujoco`` in a link.
    Names mean other things elsewhere, as ``contact`` in SDF: what such an element holds must fit.
    """
    parent = element.parent.tag if element.parent else ""
    for extension in _extensions():
        for name, entry in extension.get("grammar", {}).items():
            if name == element.tag and any(child.tag in entry for child in element.children):
                return str(extension["in"])
            if extension["in"] == parent and element.tag in entry:
                return str(name)
    return ""


@cache
def grammar_of(parent: str, tag: str) -> Grammar | None:
    """What a program reads in an element of its own; None if that is not known."""
    for extension in _extensions():
        if extension["in"] == parent and tag in extension.get("grammar", ()):
            return _grammar(extension["grammar"][tag])
    return None


def _grammar(entry: dict[str, Any]) -> Grammar:
    lists = entry[""] if isinstance(entry[""], dict) else {"": entry[""]}
    attributes = {
        name: AttributeRule(kind.removesuffix("!") or TEXT, required=kind.endswith("!"))
        for kind, names in lists.items()
        for name in names.split()
    }
    return Grammar(attributes, {tag: _grammar(child) for tag, child in entry.items() if tag})

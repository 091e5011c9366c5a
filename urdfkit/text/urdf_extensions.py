"""Elements and attributes that a program adds to URDF without a namespace prefix."""

import os
from functools import cache

from urdfkit.core.static_typing import Any
from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.text.document import Element
from urdfkit.text.schema import TEXT, AttributeRule, Grammar


@cache
def _data() -> dict[str, Any]:
    from json import load  # most models do not need it

    path = os.path.join(os.path.dirname(__file__), "urdf_extensions.json")
    with open(path, encoding="utf-8") as file:
        data: dict[str, Any] = load(file)
    return data


def _extensions() -> list[dict[str, Any]]:
    extensions: list[dict[str, Any]] = _data()["extensions"]
    return extensions


@cache
def read_in(tag: str, kind: str = "elements") -> frozenset[str]:
    """Tags that known programs read in an element, such as ``contact`` in a link.

    Args:
        kind: ``attributes`` for those that they read, such as ``concave`` of a collision.
    """
    return frozenset(
        name
        for extension in _extensions()
        if extension["in"] == tag
        for name in extension.get(kind, ())
    )


def drake_suggestion(qualified: str, kind: str = "elements") -> str:
    """The present name of a misspelt or former element or attribute of Drake; empty for others."""
    prefix, _, name = qualified.partition(":")
    if prefix != "drake":
        return ""
    data = _data()["drake"]
    known = data[kind].split()
    if name in known:
        return ""
    suggestion = data["former"].get(name) or nearest(name, known, CLOSE_TYPO)
    return f"drake:{suggestion}" if suggestion else ""


def place_of(element: Element) -> str:
    """Tag of the parent in which a program reads a misplaced element; empty if unknown.

    It is ``mujoco`` for a ``compiler`` in the robot, and ``robot`` for a ``mujoco`` in a link.
    A name can have other meanings, such as ``contact`` in SDF: the children must match, too.
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
    """The grammar of an element of a program; None if unknown."""
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

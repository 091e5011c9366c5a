"""Elements and attributes that a program adds to URDF without a namespace prefix."""

from __future__ import annotations

import os
from functools import cache


@cache
def _read(kind: str) -> frozenset[tuple[str, str]]:
    """Pairs of a tag and an element or attribute that a program reads in it."""
    from json import load  # most models need no facts

    path = os.path.join(os.path.dirname(__file__), "urdf_extensions.json")
    with open(path, encoding="utf-8") as file:
        extensions = load(file)["extensions"]
    return frozenset(
        (extension["in"], name) for extension in extensions for name in extension.get(kind, ())
    )


def has_element(parent: str, tag: str) -> bool:
    """True if a known program reads an element in another one, such as ``contact`` in a link."""
    return (parent, tag) in _read("elements")


def has_attribute(tag: str, name: str) -> bool:
    """True if a known program reads an attribute, such as ``concave`` of a collision."""
    return (tag, name) in _read("attributes")

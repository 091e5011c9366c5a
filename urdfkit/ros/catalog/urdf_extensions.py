"""Elements and attributes that a program adds to URDF without a namespace prefix."""

from __future__ import annotations

from functools import cache

from urdfkit.ros.catalog import data


@cache
def _read(kind: str) -> frozenset[tuple[str, str]]:
    """Pairs of a tag and an element or attribute that a program reads in it."""
    return frozenset(
        (extension["in"], name)
        for extension in data("urdf_extensions")["extensions"]
        for name in extension.get(kind, ())
    )


def has_element(parent: str, tag: str) -> bool:
    """True if a known program reads an element in another one, such as ``contact`` in a link."""
    return (parent, tag) in _read("elements")


def has_attribute(tag: str, name: str) -> bool:
    """True if a known program reads an attribute, such as ``concave`` of a collision."""
    return (tag, name) in _read("attributes")

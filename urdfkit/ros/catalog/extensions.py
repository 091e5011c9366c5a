"""Children of ``<gazebo>``: what Gazebo's URDF converter handles, and what SDF reads there."""

from __future__ import annotations

from functools import cache
from typing import Any

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data


class Extension(Record):
    """A tag that the converter handles by name.

    Attributes:
        tag: its name.
        on: what the block must refer to: ``link``, ``joint``, ``model`` (nothing) or ``any``.
        type: ``float``, ``int``, ``bool``, ``vector3``, ``string``, ``container`` or ``any``.
        unit: of the number; empty if it has none.
        words: of a bool: ``yes`` if only true, yes and 1 mean true, ``no`` if only false, no and
            0 mean false; empty for the other types.
    """

    tag: str
    on: str
    type: str
    unit: str
    words: str


@cache
def _content() -> dict[str, Any]:
    return data("extensions")


@cache
def extensions() -> dict[str, Extension]:
    """The tags that the converter handles, by name."""
    return {
        tag: Extension(tag, fact["on"], fact["type"], fact.get("unit", ""), fact.get("words", ""))
        for tag, fact in _content()["tags"].items()
    }


def copied(kind: str) -> list[str]:
    """The tags that SDF reads in a ``link``, ``joint``, ``model``, ``visual`` or ``collision``."""
    found: list[str] = _content()["children"][kind]
    return found


def suggested() -> dict[str, str]:
    """Wrong names that people write, with the right ones."""
    found: dict[str, str] = _content()["meant"]
    return found


def rewritten() -> list[str]:
    """Parameters of model plugins in which the converter puts the survivor for a merged link."""
    found: list[str] = _content()["rewritten"]
    return found

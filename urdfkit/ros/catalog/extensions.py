"""Children of ``<gazebo>``: what Gazebo's URDF converter handles, and what SDF reads there."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data, record


class Extension(Record):
    """A tag that the converter handles by name."""

    tag: str  # its name
    on: str  # what the block must refer to: ``link``, ``joint``, ``model`` (nothing) or ``any``
    type: str  # ``float``, ``int``, ``bool``, ``vector3``, ``string``, ``container`` or ``any``
    unit: str = ""  # of the number; empty if it has none
    #: Of a bool: ``yes`` if only true, yes and 1 mean true, ``no`` if only false, no and 0 mean
    #: false; empty for the other types.
    words: str = ""


@cache
def extensions() -> dict[str, Extension]:
    """The tags that the converter handles, by name."""
    tags = data("extensions")["tags"]
    return {tag: record(Extension, fact, tag=tag) for tag, fact in tags.items()}


def copied(kind: str) -> list[str]:
    """The tags that SDF reads in a ``link``, ``joint``, ``model``, ``visual`` or ``collision``."""
    return list(data("extensions")["children"][kind])


def suggested() -> dict[str, str]:
    """Wrong names that people write, with the right ones."""
    return dict(data("extensions")["meant"])


def rewritten() -> list[str]:
    """Parameters of model plugins in which the converter puts the survivor for a merged link."""
    return list(data("extensions")["rewritten"])

"""Children of ``<gazebo>`` that Gazebo's URDF converter handles, or that SDF reads."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data, record


class Extension(Record):
    """A tag that the converter handles by name."""

    tag: str  # its name
    on: str  # reference of the block: ``link``, ``joint``, ``model`` (none) or ``any``
    type: str  # ``float``, ``int``, ``bool``, ``vector3``, ``string``, ``container`` or ``any``
    sdf: str  # the path of what it becomes
    unit: str = ""  # of a number; empty without a unit
    #: Of a bool: ``yes`` if only true, yes and 1 are true, ``no`` if only false, no and 0 are
    #: false; empty for other types.
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
    """Correct names by common wrong name."""
    return dict(data("extensions")["meant"])


def rewritten() -> list[str]:
    """Parameters of model plugins in which the converter renames merged links."""
    return list(data("extensions")["rewritten"])

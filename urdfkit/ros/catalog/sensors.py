"""Sensors of SDF: which types there are, and who makes them."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data, record


class SensorType(Record):
    """A type of sensor."""

    blocks: tuple[str, ...]  # the children that may hold its settings; empty if it has none
    #: classic and gz: true if Gazebo Classic, or gz-sim, makes it.
    classic: bool
    gz: bool
    #: gz_name and classic_name: what it is called there, if otherwise.
    gz_name: str | None
    classic_name: str | None


@cache
def types() -> dict[str, SensorType]:
    return {name: record(SensorType, entry) for name, entry in data("sensors")["types"].items()}


@cache
def children() -> frozenset[str]:
    """The children that a sensor may have, those of every type included."""
    content = data("sensors")
    return frozenset((*content["children"], *content["blocks"]))


class Setting(Record):
    """An element, or with ``@`` an attribute, in the block that holds a sensor's settings."""

    type: str  # ``container``, ``float``, ``int``, ``uint``, ``bool``, ``string``, ``vector3``...
    words: tuple[str, ...] = ()  # the values that it may have; empty if any
    #: minimum and maximum: bounds of a number; None without one.
    minimum: float | None = None
    maximum: float | None = None


@cache
def settings(block: str) -> dict[str, Setting]:
    """What a block may hold, by path, such as ``image/width``; empty for an unknown block."""
    written = data("sensors")["settings"].get(block, {})
    return {path: _setting(text) for path, text in written.items()}


def _setting(text: str) -> Setting:
    """Read ``TYPE``, ``in WORDS``, ``>= MINIMUM``, ``<= MAXIMUM``."""
    kind, _, words = text.partition(" in ")
    kind, _, maximum = kind.partition(" <= ")
    kind, _, minimum = kind.partition(" >= ")
    return Setting(
        kind,
        tuple(words.split()),
        float(minimum) if minimum else None,
        float(maximum) if maximum else None,
    )

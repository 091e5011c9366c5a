"""Types of sensors in SDF, and the simulators that support them."""

from __future__ import annotations

from functools import cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data, record


class SensorType(Record):
    """A type of sensor."""

    #: classic and gz: True if Gazebo Classic, or gz-sim, supports it.
    classic: bool
    gz: bool
    #: gz_name and classic_name: its name there, if different.
    gz_name: str | None
    classic_name: str | None


@cache
def types() -> dict[str, SensorType]:
    return {name: record(SensorType, entry) for name, entry in data("sensors")["types"].items()}


def type_in_gz(name: str) -> str:
    """The name of a type in gz-sim, which also reads ``gps`` and ``depth``; empty for others."""
    kind = types().get(name)
    return (kind.gz_name or name) if kind and kind.gz else ""


@cache
def children() -> frozenset[str]:
    """Valid children of a sensor, including those of all types."""
    content = data("sensors")
    return frozenset((*content["children"], *content["blocks"]))


class Setting(Record):
    """An element, or with ``@`` an attribute, in the block of a sensor's settings."""

    type: str  # ``container``, ``float``, ``int``, ``uint``, ``bool``, ``string``, ``vector3``...
    words: tuple[str, ...] = ()  # valid values; empty if all are valid
    #: minimum and maximum: bounds of a number; None without a bound.
    minimum: float | None = None
    maximum: float | None = None


@cache
def settings(block: str) -> dict[str, Setting]:
    """Valid settings of a block by path, such as ``image/width``; empty for an unknown block."""
    definitions = data("sensors")["settings"].get(block, {})
    return {path: _setting(text) for path, text in definitions.items()}


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

"""Sensors of SDF: which types there are, and who makes them."""

from __future__ import annotations

from functools import cache

from urdfkit.catalog import data
from urdfkit.record import Record


class SensorType(Record):
    """A type of sensor.

    Attributes:
        blocks: the children that may hold its settings; empty if it has none.
        classic, gz: True if Gazebo Classic, or gz-sim, makes it.
        gz_name, classic_name: what it is called there, if otherwise.
    """

    blocks: tuple[str, ...]
    classic: bool
    gz: bool
    gz_name: str | None
    classic_name: str | None


@cache
def types() -> dict[str, SensorType]:
    """Every type, by name."""
    return {
        name: SensorType(
            tuple(entry["block"]),
            entry["classic"],
            entry["gz"],
            entry["gz_name"],
            entry["classic_name"],
        )
        for name, entry in data("sensors")["types"].items()
    }


@cache
def children() -> frozenset[str]:
    """The children that a sensor may have, those of every type included."""
    content = data("sensors")
    return frozenset((*content["children"], *content["blocks"]))

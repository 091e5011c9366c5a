"""Sensors of Gazebo: types, rates, ranges, frames."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Codes and names of rules that others have absorbed.
REDIRECTS = {
    "GAZ041": "GAZ040", "sensor-not-in-target": "GAZ040", "unknown-sensor-type": "GAZ040",
    "GAZ062": "GAZ040", "sensor-on-wrong-kind": "GAZ040", "GAZ065": "GAZ040",
    "noise-without-type": "GAZ040",
    "angle-in-degrees": "GAZ047", "GAZ056": "GAZ047", "field-of-view-in-degrees": "GAZ047",
    "sensor-sees-itself": "GAZ050",
    "GAZ054": "", "heavy-sensor": "", "GAZ044": "", "conflicting-rates": "",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if a ``<gazebo>`` element holds a sensor."""
    return any(part.tag == "sensor" for block in subject.model.gazebo for part in block.walk())

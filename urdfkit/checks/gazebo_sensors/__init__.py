"""Sensors of Gazebo: types, rates, ranges, frames."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

#: Codes and names of rules that others have absorbed.
REDIRECTS = {
    "angle-in-degrees": "GAZ047",
    "GAZ056": "GAZ047",
    "field-of-view-in-degrees": "GAZ047",
}


def applies(subject: Subject) -> bool:
    """True if a ``<gazebo>`` element holds a sensor."""
    return any(part.tag == "sensor" for block in subject.model.gazebo for part in block.walk())

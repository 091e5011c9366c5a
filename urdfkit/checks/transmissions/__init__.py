"""``<transmission>`` elements."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names of rules.
REDIRECTS = {
    "RCT003": "RCT024", "RCT015": "RCT024", "RCT016": "RCT024", "RCT030": "RCT024",
    "transmission-refused": "RCT024", "hardware-interface-missing": "RCT024",
    "transmission-in-ros2": "RCT024", "transmission-incomplete": "RCT024",
    "joint-transmitted-twice": "RCT024",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if there are transmissions."""
    return bool(subject.model.transmissions)

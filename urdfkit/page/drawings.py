"""Drawings and pictures of a robot, each as an address that holds the whole picture."""

from __future__ import annotations

import base64
from typing import TYPE_CHECKING

from urdfkit.diagrams import svg

if TYPE_CHECKING:
    from urdfkit.subject import Subject

#: A tree of more links is no help as a drawing.
MAX_LINKS = 400


def tree(subject: Subject) -> str | None:
    """The kinematic tree; None if it is too large, or there is none."""
    if subject.reading.document is None or not 0 < len(subject.model.links) <= MAX_LINKS:
        return None
    return address("image/svg+xml", svg.render(subject.tree).encode("utf-8", "replace"))


def address(kind: str, data: bytes) -> str:
    """A ``data:`` address; a picture behind one runs no scripts, whatever is in it."""
    return f"data:{kind};base64,{base64.b64encode(data).decode('ascii')}"

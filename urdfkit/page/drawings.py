"""Drawings and pictures of a robot, each as an address that holds the whole picture."""

from __future__ import annotations

import base64
import io
from typing import TYPE_CHECKING

from urdfkit.diagrams import svg
from urdfkit.page.document import Document

if TYPE_CHECKING:
    from PIL.Image import Image

    from urdfkit.render import Scene
    from urdfkit.subject import Subject

#: A tree of more links is no help as a drawing.
MAX_LINKS = 400
VIEWS = ("iso", "front", "left", "top")
#: Pixels of the sheet of all views, and of the picture of the findings.
SHEET, MARKED = (1280, 720), (960, 540)

#: Of links with findings, by the worst of them, and of the others.
_COLOURS = {"error": (0.86, 0.15, 0.12, 1.0), "warning": (0.96, 0.68, 0.1, 1.0)}
_OTHERS = (0.8, 0.82, 0.85, 1.0)


def tree(subject: Subject) -> dict[str, str]:
    """The kinematic tree, if there is one that can be drawn."""
    if subject.reading.document is None or not 0 < len(subject.model.links) <= MAX_LINKS:
        return {}
    return {"tree": address("image/svg+xml", svg.render(subject.tree).encode("utf-8", "replace"))}


def pictures(built: Scene, document: Document) -> dict[str, str]:
    """The robot from four sides; and with the links of errors and warnings in colour."""
    from urdfkit.render import picture

    seen = built._replace(items=tuple(item for item in built.items if item.role == "visual"))
    if not seen.items:
        return {}
    found = {"picture": webp(picture(seen, VIEWS, size=SHEET))}
    marked = _marked(seen, _worst(document))
    if marked is not None:
        found["marked"] = webp(picture(marked, size=MARKED))
    return found


def _worst(document: Document) -> dict[str, str]:
    """The severity of the worst error or warning of each link."""
    found: dict[str, str] = {}
    for severity in ("warning", "error"):
        for one in document["findings"]:
            if one["severity"] == severity:
                found |= dict.fromkeys(one["links"], severity)
    return found


def _marked(seen: Scene, worst: dict[str, str]) -> Scene | None:
    """The scene with colours for findings; None if they concern nothing that is seen."""
    from urdfkit.render import Look

    if worst.keys().isdisjoint(item.link for item in seen.items):
        return None
    colours = {link: Look(_COLOURS[severity]) for link, severity in worst.items()}
    other = Look(_OTHERS)
    items = (
        item._replace(look=colours.get(item.link, other), colors=None, uv=None)
        for item in seen.items
    )
    return seen._replace(items=tuple(items))


def webp(image: Image) -> str:
    data = io.BytesIO()
    image.save(data, "WEBP", quality=88)
    return address("image/webp", data.getvalue())


def address(kind: str, data: bytes) -> str:
    """A ``data:`` address; a picture behind one runs no scripts, whatever is in it."""
    return f"data:{kind};base64,{base64.b64encode(data).decode('ascii')}"

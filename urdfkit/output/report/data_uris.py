"""Drawings and images of a robot, each as an address that holds the whole image."""

from __future__ import annotations

import base64
import io
from collections.abc import Sequence
from typing import TYPE_CHECKING

from urdfkit.output.diagrams import svg

if TYPE_CHECKING:
    from PIL.Image import Image

    from urdfkit.lint.context import Context
    from urdfkit.render import Scene
    from urdfkit.text.diagnostic import Diagnostic

#: A tree of more links is no help as a drawing.
MAX_LINKS = 400
VIEWS = ("iso", "front", "left", "top")
#: Pixels of the sheet of all views, and of the image of the findings.
SHEET, MARKED = (1280, 720), (960, 540)


def tree(context: Context) -> dict[str, str]:
    """The kinematic tree, if there is one that can be drawn."""
    if context.reading.document is None or not 0 < len(context.model.links) <= MAX_LINKS:
        return {}
    return {"tree": address("image/svg+xml", svg.render(context.tree).encode("utf-8", "replace"))}


def images(built: Scene, context: Context, diagnostics: Sequence[Diagnostic]) -> dict[str, str]:
    """The robot from four sides; and with the links of errors and warnings in colour."""
    from urdfkit.render import marked, render_image

    seen = built._replace(items=tuple(item for item in built.items if item.role == "visual"))
    if not seen.items:
        return {}
    found = {"views": webp(render_image(seen, VIEWS, size=SHEET))}
    coloured = marked(seen, context, diagnostics)
    if coloured.labels:
        found["marked"] = webp(render_image(coloured, size=MARKED))
    return found


def webp(image: Image) -> str:
    data = io.BytesIO()
    image.save(data, "WEBP", quality=88)
    return address("image/webp", data.getvalue())


def address(kind: str, data: bytes) -> str:
    """A ``data:`` address; an image behind one runs no scripts, whatever is in it."""
    return f"data:{kind};base64,{base64.b64encode(data).decode('ascii')}"

"""Drawings and images of a robot as ``data:`` URIs."""

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

#: Most links of a kinematic tree that is drawn.
MAX_LINKS = 400
VIEWS = ("iso", "front", "left", "top")
#: Size in pixels of the sheet of all views, and of the image of the findings.
SHEET, MARKED = (1280, 720), (960, 540)


def tree(context: Context) -> dict[str, str]:
    """Drawing of the kinematic tree; empty if it is missing or too large."""
    if context.reading.document is None or not 0 < len(context.model.links) <= MAX_LINKS:
        return {}
    return {"tree": address("image/svg+xml", svg.render(context.tree).encode("utf-8", "replace"))}


def images(built: Scene, context: Context, diagnostics: Sequence[Diagnostic]) -> dict[str, str]:
    """Images of the robot from four sides, and with links of errors and warnings coloured.

    A robot without visuals is drawn by its collisions.
    """
    from urdfkit.render import marked, render_image

    items = tuple(item for item in built.items if item.role == "visual")
    visuals = built._replace(items=items or built.items)
    if not visuals.items:
        return {}
    uris = {"views": webp(render_image(visuals, VIEWS, size=SHEET))}
    coloured = marked(visuals, context, diagnostics)
    if coloured.labels:
        uris["marked"] = webp(render_image(coloured, size=MARKED))
    return uris


def webp(image: Image) -> str:
    data = io.BytesIO()
    image.save(data, "WEBP", quality=88)
    return address("image/webp", data.getvalue())


def address(kind: str, data: bytes) -> str:
    """A ``data:`` URI; scripts in an image with such a URI do not run."""
    return f"data:{kind};base64,{base64.b64encode(data).decode('ascii')}"

"""A robot as the page draws it: its visuals in the zero configuration, and their findings."""

from collections.abc import Iterator
from itertools import islice
from typing import Any

import urdfkit
from urdfkit.core.spatial import Transform
from urdfkit.lint.report import Report
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.element_lookup import ElementLookup
from urdfkit.robot.model import Body, Link, Shape
from urdfkit.ros.catalog.materials import materials
from urdfkit.ros.gazebo.values import text_of
from urdfkit.text.file_kinds import is_launch

#: A page of more would not turn.
MOST_BODIES = 2000


def scene(report: Report, shown: str) -> dict[str, Any] | None:
    """The visuals of the robot in the editor, or of the first robot; None if none can be read.

    The links of each finding are in the order of the report's findings.
    """
    robots = [file for file in report.files if not is_launch(file)]
    for file in [shown, *robots] if shown in robots else robots:
        try:
            context = urdfkit.read(file)
        except urdfkit.UrdfkitError:
            continue
        return {
            "file": file,
            "bodies": list(_bodies(context)),
            "links": _links(report, context),
        }
    return None


def _bodies(context: urdfkit.Context) -> Iterator[dict[str, Any]]:
    """Each visual with its place, shape and colour; lengths in m, colours as written (sRGB)."""
    colours = Colours(context.model)
    gazebo = {
        block.get("reference"): materials().get(text_of(material))
        for block in context.model.gazebo
        if (material := block.child("material"))
    }
    frames = urdfkit.frames(context.tree, {})
    for link, body in _visuals(context):
        if link.name not in frames or body.shape is None:
            continue
        own, named = colours.of(body), gazebo.get(link.name)
        rgba = own.rgba.value if own and own.rgba else named.rgba if named else None
        yield {
            "link": link.name,
            "matrix": _matrix(frames[link.name] @ body.origin),
            "rgba": rgba,
            **_shape(context, link, body.shape),
        }


def _visuals(context: urdfkit.Context) -> Iterator[tuple[Link, Body]]:
    return islice(
        ((link, body) for link in context.model.links for body in link.visuals), MOST_BODIES
    )


def _shape(context: urdfkit.Context, link: Link, shape: Shape) -> dict[str, Any]:
    """What is drawn of a visual; for a mesh that is missing, the box of the link's collision."""
    if shape.kind != "mesh":
        sizes = {"size": shape.size, "radius": shape.radius, "length": shape.length}
        return {"kind": shape.kind, **sizes}
    path = context.files.find(shape.filename) if shape.filename else None
    if path:
        return {"kind": "mesh", "path": path, "scale": shape.scale}
    halves = (one.shape.half_extents for one in link.collisions if one.shape)
    half = next((one for one in halves if one), (0.025, 0.025, 0.025))
    return {"kind": "missing", "size": [2 * edge for edge in half]}


def _links(report: Report, context: urdfkit.Context) -> list[list[str]]:
    """The links that each finding concerns; none for a finding of another robot."""
    lookup = ElementLookup(context.model)
    xacro = context.reading.xacro
    sources = xacro.sources if xacro else (context.source,)
    files = {source.path for source in sources}
    return [
        sorted({name for call in one.calls if (name := lookup.link(call.element))})
        if one.span.source.path in files
        else []
        for one in report.diagnostics
    ]


def _matrix(frame: Transform) -> list[float]:
    """Sixteen numbers, column by column."""
    (a, b, c), position = frame.rotation, frame.position
    columns = zip(a, b, c, strict=True)
    return [v for column in columns for v in (*column, 0.0)] + [*position, 1.0]

"""A robot as the 3D view of the page takes it: links, joints, bodies, and the links of findings."""

from collections.abc import Iterator
from itertools import islice
from typing import Any

import urdfkit
from urdfkit.lint.report import Report
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.element_lookup import ElementLookup
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.robot.viewer_model import matrix, viewer_model
from urdfkit.ros.catalog.materials import materials
from urdfkit.ros.gazebo.values import text_of
from urdfkit.text.file_kinds import is_launch

#: A page of more would not turn.
MOST_BODIES = 2000


def scene(report: Report, shown: str) -> dict[str, Any] | None:
    """The robot in the editor, or else the first robot; None if none can be read.

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
            "robot": viewer_model(context.model, context.tree),
            "bodies": list(islice(_bodies(context), MOST_BODIES)),
            "findings": _links(report, context),
        }
    return None


def _bodies(context: urdfkit.Context) -> Iterator[dict[str, Any]]:
    """Each visual and collision with its place in the link, shape and colour.

    Lengths in m, colours as written (sRGB).
    """
    colours = Colours(context.model)
    gazebo = {
        block.get("reference"): materials().get(text_of(material))
        for block in context.model.gazebo
        if (material := block.child("material"))
    }
    for link in context.model.links:
        named = gazebo.get(link.name)
        for body in link.visuals:
            own = colours.of(body)
            rgba = own.rgba.value if own and own.rgba else None
            texture = context.files.find(own.texture) if own and own.texture else None
            yield {
                **_body(context, link, "visual", body),
                "rgba": rgba,
                "texture": texture,
                "gazebo": named.rgba if named else None,
            }
        for body in link.collisions:
            yield _body(context, link, "collision", body)


def _body(context: urdfkit.Context, link: Link, role: str, body: Body) -> dict[str, Any]:
    shape = _shape(context, link, body.shape) if body.shape else {"kind": ""}
    return {"link": link.name, "role": role, "matrix": matrix(body.origin), **shape}


def _shape(context: urdfkit.Context, link: Link, shape: Shape) -> dict[str, Any]:
    """What is drawn of a body; for a mesh that is missing, the box of the link's collision."""
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

"""``urdfkit mesh info``: the contents of mesh files."""

from collections.abc import Iterator

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats, limited
from urdfkit.cli.mesh import tables
from urdfkit.cli.progress import progress_bar
from urdfkit.core.strict_json import dumped
from urdfkit.core.words import spaced
from urdfkit.mesh.describe import MeshDescription, describe
from urdfkit.mesh.geometry import MeshPart

VERSION = 1


@described("info")
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
@in_formats("text", "json")
@limited
def command(files: tuple[str, ...], format: str) -> int:
    """Show size, triangles, unit and defects of mesh files.

    Exit codes: 0 done, 2 a file has no triangles.

    Examples:
        urdfkit mesh info meshes/arm.dae meshes/hand.stl
    """
    with progress_bar("mesh files") as bar:
        descriptions = []
        for done, file in enumerate(files):
            if bar is not None:
                bar(done, len(files))
            descriptions.append(describe(file))
    if format == "json":
        document = {"version": VERSION, "meshes": [mesh.as_json() for mesh in descriptions]}
        output.write(dumped(document))
    else:
        output.write("\n\n".join("\n".join(render(mesh)) for mesh in descriptions) + "\n")
    return 0


def render(description: MeshDescription) -> Iterator[str]:
    yield f"{description.path}: {description.format}, {description.bytes:,} bytes"
    if description.defect:
        yield from output.indented(f"broken: {description.defect}")
    size = [high - low for low, high in zip(description.low, description.high, strict=True)]
    yield "  size       {:.4g} x {:.4g} x {:.4g} m".format(*size)
    ranges = [
        f"{low:.4g} to {high:.4g}"
        for low, high in zip(description.low, description.high, strict=True)
    ]
    yield "  reaches    x {}, y {}, z {}".format(*ranges)
    health = description.health
    bodies = "1 body" if health.bodies == 1 else f"{health.bodies} bodies"
    yield f"  triangles  {health.faces:,} in {bodies}"
    yield from output.labelled("surface", tables.surface(health))
    if health.is_solid:
        yield f"  volume     {tables.volume(health.volume)}"
    yield f"  area       {description.area:.4g} m²"
    if description.mesh.unit != 1.0:
        yield f"  unit       {description.mesh.unit:g} m, applied above"
    if description.mesh.up_axis:
        yield f"  up axis    {description.mesh.up_axis}, not applied"
    for part in description.mesh.parts:
        yield from output.labelled("part", _part(part))
    for lost in description.mesh.losses:
        yield from output.labelled("lost", lost)


def _part(part: MeshPart) -> str:
    text = f"{len(part.faces):,} triangles"
    if part.material is None:
        return text
    color = spaced(part.material.rgba, 3)
    texture = ", with a texture" if part.material.texture else ""
    return f"{text}, {part.material.name or 'unnamed'} ({color}){texture}"

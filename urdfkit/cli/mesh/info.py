"""``urdfkit mesh info``: what mesh files hold."""

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
def command(files: tuple[str, ...], form: str) -> int:
    """Show size, triangles, unit and defects of mesh files.

    Exit codes: 0 done, 2 a file has no triangles.

    Examples:
        urdfkit mesh info meshes/arm.dae meshes/hand.stl
    """
    with progress_bar("mesh files") as bar:
        found = []
        for done, file in enumerate(files):
            if bar is not None:
                bar(done, len(files))
            found.append(describe(file))
    if form == "json":
        document = {"version": VERSION, "meshes": [one.as_json() for one in found]}
        output.write(dumped(document))
    else:
        output.write("\n\n".join("\n".join(render(one)) for one in found) + "\n")
    return 0


def render(found: MeshDescription) -> Iterator[str]:
    yield f"{found.path}: {found.format}, {found.bytes} bytes"
    if found.defect:
        yield from output.indented(f"broken: {found.defect}")
    size = [high - low for low, high in zip(found.low, found.high, strict=True)]
    yield "  size       {:.4g} x {:.4g} x {:.4g} m".format(*size)
    ranges = [f"{low:.4g} to {high:.4g}" for low, high in zip(found.low, found.high, strict=True)]
    yield "  reaches    x {}, y {}, z {}".format(*ranges)
    bodies = found.health.bodies
    yield f"  triangles  {found.health.faces} in {bodies} {'body' if bodies == 1 else 'bodies'}"
    yield from output.labelled("surface", tables.surface(found.health))
    if found.health.is_solid:
        yield f"  volume     {tables.volume(found.health.volume)}"
    yield f"  area       {found.area:.4g} m^2"
    if found.mesh.unit != 1.0:
        yield f"  unit       {found.mesh.unit:g} m, applied above"
    if found.mesh.up_axis:
        yield f"  up axis    {found.mesh.up_axis}, not applied"
    for part in found.mesh.parts:
        yield from output.labelled("part", _part(part))
    for lost in found.mesh.losses:
        yield from output.labelled("lost", lost)


def _part(part: MeshPart) -> str:
    text = f"{len(part.faces)} triangles"
    if part.material is None:
        return text
    color = spaced(part.material.rgba, 3)
    texture = ", with a texture" if part.material.texture else ""
    return f"{text}, {part.material.name or 'unnamed'} ({color}){texture}"

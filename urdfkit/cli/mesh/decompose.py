"""``urdfkit mesh decompose``: a mesh cut into convex pieces."""

import os

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import choice, described, limited, option
from urdfkit.cli.mesh import tables
from urdfkit.cli.mesh.saving import FORCE, destination, save
from urdfkit.cli.progress import working
from urdfkit.mesh.containment import missing, protrusion
from urdfkit.mesh.convex_decomposition import ENGINES, decompose
from urdfkit.mesh.convex_hull import hull
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.health import examine, examine_mesh
from urdfkit.mesh.io.load import load
from urdfkit.mesh.transforms import in_metres


@described("decompose")
@click.argument("file", metavar="FILE")
@option("-o, --output OUT", "Write the pieces to this file.", to="out")
@option("--split", "One file for each piece: OUT_1, OUT_2, ...")
@option("--most N", "Maximum number of pieces.", type=int, default=16)
@choice("--engine", of=ENGINES, help="Decomposition algorithm.")
@FORCE
@limited
def command(file: str, out: str | None, split: bool, most: int, engine: str, force: bool) -> int:
    """Decompose a mesh into convex pieces for physics engines.

    Together the pieces contain the surface of the mesh. For a convex mesh, its hull is written.

    Exit codes: 0 done, 2 usage or input error.

    Examples:
        urdfkit mesh decompose arm.dae -o arm_pieces.obj --most 8
    """
    if most < 1:
        raise options.UsageError("--most must be 1 or more")
    if split and not out:
        raise options.UsageError("--split needs --output")
    path = None if split else destination(file, out, False, force)
    with working():
        mesh = in_metres(load(file))
        result = decompose(mesh, most=most, engine=engine)
    # Pieces that touch are one body for `examine_mesh`.
    after = examine_mesh(result)._replace(bodies=len(result.parts))
    lines = [*tables.columns(tables.before_and_after(examine_mesh(mesh), after))]
    for number, part in enumerate(result.parts, start=1):
        health = examine(part.vertices, part.faces)
        lines.append(f"  piece {number}: {health.faces} triangles, {tables.volume(health.volume)}")
    lines += tables.beyond(protrusion(result, mesh), missing(result, mesh))
    if len(result.parts) > 1:
        lines.append(
            f"its convex hull sticks out by     {tables.length(protrusion(hull(mesh), mesh))}"
        )
    if split and out:
        stem, suffix = os.path.splitext(out)
        pieces = {f"{stem}_{n}{suffix}": Mesh((part,)) for n, part in enumerate(result.parts, 1)}
        for name in pieces:
            destination(file, name, False, force)  # before the first of them is written
        for name, piece in pieces.items():
            lines += save(piece, name)
    elif path is None:
        lines.append("nothing written; use --output OUT")
    else:
        lines += save(result, path)
    output.page(lines)
    return 0

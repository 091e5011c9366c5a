"""``urdfkit mesh convert``: a mesh in another format."""

from math import inf

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import described, limited, option
from urdfkit.cli.mesh.saving import FORCE, save
from urdfkit.cli.progress import working
from urdfkit.mesh.io.load import load
from urdfkit.mesh.transforms import scaled, upright
from urdfkit.mesh.writers import require_replaceable


@described("convert")
@click.argument("file", metavar="FILE")
@option("-o, --output OUT", "Write the mesh to this file.", to="out", required=True)
@option("--upright", "Rotate the up axis of the file to z.", to="turn")
@option("--scale FACTOR", "Multiply all lengths.", type=float, default=1.0)
@FORCE
@limited
def command(file: str, out: str, turn: bool, scale: float, force: bool) -> int:
    """Convert a mesh to another format, or clean it.

    The suffix of OUT selects the format. The unit of FILE is applied: OUT is in metres.

    Exit codes: 0 done, 2 usage or input error.

    Examples:
        urdfkit mesh convert arm.dae -o arm.stl
        urdfkit mesh convert arm_mm.stl -o arm.stl --scale 0.001
    """
    if not 0 < scale < inf:
        raise click.BadParameter("must be more than 0, and finite", param_hint="--scale")
    mesh = load(file)
    if not force:
        require_replaceable(out)
    mesh = scaled(upright(mesh) if turn else mesh, (scale,) * 3)
    with working():
        lines = [*save(mesh, out)]
    for lost in mesh.losses:
        lines += output.indented(f"not kept: {lost}")
    output.page(lines)
    return 0

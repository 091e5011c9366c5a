"""``urdfkit mesh``: the commands about mesh files."""

import click

from urdfkit.cli.lazy import LazyGroup

SECTIONS = {
    "Any mesh file": ("info", "convert", "repair", "simplify", "hull", "decompose"),
    "The meshes of a robot": ("collision", "spheres", "capsules", "generate"),
}


@click.group(
    "mesh",
    cls=LazyGroup,
    package="urdfkit.cli.mesh",
    sections=SECTIONS,
    extra="meshes",
    invoke_without_command=True,
)
@click.pass_context
def command(context: click.Context) -> int:
    """Inspect, convert, repair, simplify and generate mesh files."""
    if context.invoked_subcommand is None:
        click.echo(context.get_help())
    return 0

"""Output files of mesh commands: a new file, or the input file."""

from collections.abc import Callable, Iterator
from functools import wraps
from typing import Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import option, with_options
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.writers import GLB_NOTE, losses, require_replaceable, write
from urdfkit.text.source import shown

FORCE = option("--force", "Replace OUT even if it is a valid mesh.")
_ADD_OPTIONS = with_options(
    FORCE,
    option("--write", "Replace FILE itself.", to="in_place"),
    option("-o, --output OUT", "Write the mesh to this file.", to="out"),
)


def writes(command: Callable[..., int]) -> Callable[..., int]:
    """Add FILE and the options for the output file to a command.

    The command receives ``file``, and ``path`` of the output; None to write nothing.
    """

    @wraps(command)
    def resolved(file: str, out: str | None, in_place: bool, force: bool, **values: Any) -> int:
        return command(file=file, path=destination(file, out, in_place, force), **values)

    return click.argument("file", metavar="FILE")(_ADD_OPTIONS(resolved))


def destination(file: str, out: str | None, in_place: bool, force: bool) -> str | None:
    """The output file; None to write nothing.

    Raises:
        UsageError: both a file and in place.
        SoundMesh: the file is a valid mesh, and must not be replaced.
    """
    if out and in_place:
        raise options.UsageError("--output and --write cannot be combined")
    if in_place:
        return file
    if out and not force:
        require_replaceable(out)
    return out


def save(mesh: Mesh, path: str | None) -> Iterator[str]:
    if path is None:
        yield "nothing written; use --output OUT or --write"
        return
    yield "wrote " + ", ".join(map(shown, write(mesh, path)))
    if lost := losses(mesh, path):
        yield f"  this format cannot store: {', '.join(lost)}"
    if path.lower().endswith(".glb"):
        yield from output.indented(GLB_NOTE)

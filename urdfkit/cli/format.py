"""``urdfkit format``: one layout for URDF and xacro files."""

import os
from typing import Any

import click

from urdfkit.cli import options, output, stdin
from urdfkit.cli.decorators import CONFIG, ISOLATED, described, option, with_options
from urdfkit.cli.progress import working
from urdfkit.lint.formatting import Formatted, format_files
from urdfkit.text.editing.formatter import WIDTH, formatted
from urdfkit.text.editing.rewriting import Rewrite
from urdfkit.text.source import STANDARD_INPUT, shown


@described("format")
@click.argument("files", nargs=-1, required=True, metavar="FILE...")
@option("--check", "Write nothing; exit with 1 if a file would change.")
@option("--diff", "As --check, and show the changes as a diff.")
@option("--width COLUMNS", f"Line width. [default: {WIDTH}]", type=click.IntRange(40, 400))
@option("-q, --quiet", "Print errors and nothing else.")
@option("--force", "Also format files that are generated, read-only or ignored by git.")
@with_options(ISOLATED, CONFIG)
def command(
    files: tuple[str, ...],
    check: bool,
    diff: bool,
    width: int | None,
    quiet: bool,
    force: bool,
    **configured: Any,
) -> int:
    """Format URDF and xacro files without changing the model.

    FILE is a model, or a directory: all models in it are formatted. '-' reads standard input and
    writes to standard output.

    Exit codes: 0 done, 1 a file would change (--check, --diff), 2 a file cannot be read.

    Examples:
        urdfkit format urdf
        urdfkit format --check .
    """
    is_stdin = files == ("-",)
    near = os.curdir if is_stdin else files[0]
    settings = options.config({**configured, "trust": False}, near)
    width = width or (settings.width if settings else 0)
    if is_stdin:
        return _standard_input(width or WIDTH, check=check, diff=diff)
    with working():
        result = format_files(
            *files, width=width, force=force, check=check or diff, config=settings
        )
    if diff:
        output.write_diff(result.diff())
    elif not check:
        result.write()
    _print_result(result, "would be reformatted" if check or diff else "reformatted", quiet=quiet)
    if result.failed:
        return 2
    return int(bool(result.files) and (check or diff))


def _standard_input(width: int, *, check: bool, diff: bool) -> int:
    source = stdin.read(STANDARD_INPUT)
    rewrite = Rewrite(source.path, source.data, formatted(source, width))
    if diff:
        output.write_diff(rewrite.diff())
    elif not check:
        output.write(rewrite.after.decode())
    return int((check or diff) and rewrite.after != rewrite.before)


def _print_result(result: Formatted, done: str, *, quiet: bool) -> None:
    """Print the changed files to standard error."""
    errors = [f"error: {reason}" for _, reason in result.failed]
    lines = [f"{done}: {shown(file.path)}" for file in result.files]
    lines += [f"skipped: {shown(path)}: {reason}" for path, reason in result.skipped]
    lines += errors
    lines.append(
        f"{len(result.files)} {done}, {len(result.unchanged)} unchanged"
        + (f", {len(result.skipped)} skipped" if result.skipped else "")
        + (f", {len(result.failed)} failed" if result.failed else "")
    )
    output.log(*(errors if quiet else lines))

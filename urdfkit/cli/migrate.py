"""``urdfkit migrate``: changes of a model for another generation of Gazebo."""

from collections.abc import Iterator
from typing import Any

import click

from urdfkit.cli import output, stdin
from urdfkit.cli.decorators import described
from urdfkit.cli.progress import working
from urdfkit.cli.robot import first_error, one_robot, only_file, reading
from urdfkit.errors import UnreadableRobot
from urdfkit.lint.loading import read
from urdfkit.lint.migrate import Migration, migrate
from urdfkit.lint.options import Options
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.source import Source
from urdfkit.text.terminal import printable, wrap


@described("migrate")
@one_robot
@click.option(
    "--to", "target", type=click.Choice(GAZEBO), required=True, help="Target Gazebo generation."
)
def command(inputs: dict[str, Any], target: str) -> int:
    """Show the changes that a model needs for another Gazebo.

    Replacements are printed as a diff for 'patch -p0'; nothing is written. Changes that need a
    decision, and requirements of the world, follow as comments.

    Exit codes: 0 nothing to do, 1 changes are needed, 2 the file cannot be read.

    Examples:
        urdfkit migrate robot.urdf.xacro --to gz-harmonic > robot.patch
    """
    file = only_file(inputs)
    opts = reading(inputs, file)
    source = stdin.opened(file)
    with working():
        migration = migrate(source, target, opts.arguments, opts.packages, opts.trust)
    if not migration.unread:
        _note_missing_parts(source, opts, file, is_empty=not any(migration))
    for file, reason in migration.unread.items():
        output.log(f"error: {file}: {reason}; see 'urdfkit check {file}'")
    output.write_diff("".join(render(migration, target)))
    return 2 if migration.unread else int(bool(migration.renamed or migration.left))


def _note_missing_parts(source: str | Source, opts: Options, file: str, *, is_empty: bool) -> None:
    """Note what a migration did not see: parts in packages that are not found, calls of macros."""
    try:
        robot = read(source, arguments=opts.arguments, packages=opts.packages, trust=opts.trust)
    except UnreadableRobot as error:
        output.note(f"only a part of the robot is migrated: {first_error(error, file)}")
        return
    if is_empty and not (robot.is_readable and robot.model.links):
        output.note(f"{file}: has no links; macros change with the robot that calls them")


def render(migration: Migration, target: str) -> Iterator[str]:
    """The diff, and the remaining findings as lines that ``patch`` ignores."""
    if not (migration.renamed or migration.left or migration.unread):
        yield f"nothing to do for {target}\n"
    yield migration.diff()
    for diagnostic in migration.renamed:
        if diagnostic.fix and diagnostic.code == "GAZ012":
            yield _comment(f"# {diagnostic.span}: {diagnostic.fix.title}")
    for diagnostic in migration.left:
        yield _comment(f"# {diagnostic.span}: {diagnostic.message}")
        if diagnostic.help:
            yield _comment(f"#   {diagnostic.help}")


def _comment(text: str) -> str:
    """Lines no wider than the terminal, all of which ``patch`` ignores."""
    return "\n#   ".join(wrap(printable(text), output.width() - 4).split("\n")) + "\n"

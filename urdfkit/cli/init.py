"""``urdfkit init``: a first configuration for the robots of a directory."""

import os
from collections.abc import Iterable, Iterator

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import described, option
from urdfkit.cli.progress import working
from urdfkit.cli.settings import toml_key, toml_text
from urdfkit.core import atomic
from urdfkit.core.words import counted
from urdfkit.errors import UnwritableFile
from urdfkit.lint.argument_values import found_values
from urdfkit.lint.config import Config
from urdfkit.lint.context import Context
from urdfkit.lint.discovery import discover
from urdfkit.lint.entry_points import DirectoryContents
from urdfkit.ros.targets import TARGETS
from urdfkit.text.source import Source
from urdfkit.workspace.config_file import nearest
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro

_FILE = "urdfkit.toml"


@described("init")
@click.argument("directory", default=os.curdir)
@option("--print", "Print the configuration; write nothing.", to="only_print")
def command(directory: str, only_print: bool) -> int:
    """Write a first urdfkit.toml for the robots in DIRECTORY.

    It lists every robot found, the arguments that it needs, and the detected targets. An existing
    configuration is not changed.

    Exit codes: 0 written, 2 no robot found, or a configuration exists already.

    Examples:
        urdfkit init --print
    """
    with working():
        contents = discover(directory, Config(), Resolver())
        text = render(contents, directory)
    if only_print:
        output.write(text)
        return 0
    existing = nearest(directory)
    if existing and os.path.dirname(existing) == os.path.abspath(directory):
        path = os.path.join(directory, os.path.basename(existing))
        raise UnwritableFile(f"{path}: configures it already; --print shows what would be written")
    path = os.path.join(directory, _FILE)
    if os.path.islink(path):
        raise UnwritableFile(f"{path}: a link whose target does not exist")
    atomic.write(path, output.encode(text))
    output.write(f"wrote {path}: {counted(len(contents.robots), 'robot')}\n")
    return 0


def render(contents: DirectoryContents, directory: str) -> str:
    resolver = Resolver()
    robots = [_ConfiguredRobot(robot.file, directory, resolver) for robot in contents.robots]
    lines = [
        "# Settings of urdfkit. Lines starting with '#' are comments.",
        "",
        "# Target programs; if not set, they are detected for each robot.",
        f"# targets = {_listed(name for robot in robots for name in robot.targets)}",
        "",
        "# Rules to ignore: codes, or prefixes of codes.",
        '# ignore = ["URD001"]',
        "",
    ]
    for robot in robots:
        lines += [*robot.lines(), ""]
    for library in contents.libraries:
        file = os.path.relpath(library, directory).replace(os.sep, "/")
        lines.append(f"# {file}: defines no link, and no file includes it")
    return "\n".join(lines).rstrip() + "\n"


class _ConfiguredRobot:
    """A description and its entry in a configuration."""

    def __init__(self, file: str, directory: str, resolver: Resolver) -> None:
        self.file = os.path.relpath(file, directory).replace(os.sep, "/")
        context = Context(Source.read(file), resolver)
        self._xacro = context.reading.xacro
        self._needed = context.reading.missing_arguments
        self._resolver = resolver
        is_readable = context.reading.document is not None
        self.targets = context.targets.names if is_readable else ()

    def lines(self) -> Iterator[str]:
        """The ``[[robot]]`` table with the required arguments; the others as comments."""
        yield "[[robot]]"
        yield f"file = {toml_text(self.file)}"
        if self._xacro is None:
            return
        for name in self._needed:
            yield f"arguments.{toml_key(name)} = {self._value(name, self._xacro)}"
        for name, default in self._xacro.defaults.items():
            if name not in self._needed:
                yield f"# arguments.{toml_key(name)} = {toml_text(default)}"

    def _value(self, name: str, xacro: Xacro) -> str:
        """The first possible value; the others, or an instruction, as a comment."""
        possible = found_values(name, xacro, self._resolver)
        if possible is None:
            return '""  # required: fill in the value'
        first, *others = map(toml_text, possible.values)
        return f"{first}  # or {', '.join(others)}" if others else first


def _listed(names: Iterable[str]) -> str:
    chosen = set(names)
    known = [toml_text(name) for name in TARGETS if name in chosen]
    return f"[{', '.join(known)}]" if known else '["ros2", "gz-harmonic"]'

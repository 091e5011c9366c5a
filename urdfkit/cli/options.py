"""The options of ``urdfkit check``, stated once, and what their values mean.

Importing click costs more than checking a small robot. So the ordinary command line is read by
``quick``, and everything else, help and errors included, by click: both from this table, and
both give the same values. Commands that are typed by hand now and then use click alone.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from urdfkit.errors import UrdfkitError


class Option(NamedTuple):
    """One option.

    Attributes:
        flag: as it is typed.
        help: one sentence.
        metavar: stands for the value; empty for a switch.
        choices: the values there are; any if empty.
        many: may be given several times.
        default: of an option with choices.
    """

    flag: str
    help: str
    metavar: str = ""
    choices: tuple[str, ...] = ()
    many: bool = False
    default: str | None = None

    @property
    def key(self) -> str:
        """The name of its value."""
        return self.flag[2:].replace("-", "_")

    @property
    def initial(self) -> Any:
        """The value if it is not given."""
        if self.many:
            return ()
        return self.default if self.metavar else False


#: The name of the value that holds all words that are no options.
FILES = "files"

CHECK = (
    Option(
        "--format",
        "Report in this format, to FILE or standard output; several at once. [default: text]",
        "NAME[:FILE]",
        many=True,
    ),
    Option(
        "--select", "Run these rules only: codes, beginnings of codes, names.", "CODES", many=True
    ),
    Option("--ignore", "Leave these rules out.", "CODES", many=True),
    Option(
        "--fail-on",
        "The mildest finding that makes the exit code 1.",
        "SEVERITY",
        ("error", "warning", "info"),
        default="warning",
    ),
    Option("--exit-zero", "Exit with 0 whatever is found."),
    Option("--statistics", "Instead of the findings, count them by rule."),
    Option("--package", "Where a ROS package is; before every search.", "NAME=FOLDER", many=True),
    Option("--trust", "Let the model run any expression and read any file."),
    Option(
        "--color",
        "Colours on standard output; auto: on a terminal.",
        "WHEN",
        ("auto", "always", "never"),
        default="auto",
    ),
    Option("--stdin-filename", "The name of what '-' reads.", "FILE"),
)


class UsageError(UrdfkitError):
    """The command line asks for something that cannot be."""


class Output(NamedTuple):
    """A format, and the file it is for; None is standard output."""

    format: str
    file: str | None


class CheckOptions(NamedTuple):
    """What ``urdfkit check`` is asked to do."""

    files: tuple[str, ...]
    arguments: Mapping[str, str]
    packages: Mapping[str, str]
    outputs: tuple[Output, ...]
    select: tuple[str, ...]
    ignore: tuple[str, ...]
    fail_on: str
    exit_zero: bool
    trust: bool
    color: str
    stdin_filename: str

    @classmethod
    def read(cls, values: Mapping[str, Any]) -> CheckOptions:
        """What the values of a command line mean.

        Raises:
            UsageError: one of them means nothing.
        """
        files = [word for word in values[FILES] if ":=" not in word]
        return cls(
            _files(files),
            _arguments(word for word in values[FILES] if ":=" in word),
            _packages(values["package"]),
            _outputs(values["format"], values["statistics"]),
            _codes(values["select"]),
            _codes(values["ignore"]),
            values["fail_on"],
            values["exit_zero"],
            values["trust"],
            values["color"],
            values["stdin_filename"] or "<stdin>",
        )


def _files(files: list[str]) -> tuple[str, ...]:
    if not files:
        raise UsageError("no file to check; name a URDF or xacro file, or '-' for standard input")
    if files.count("-") > 1:
        raise UsageError("'-' stands for standard input, which can be read once only")
    for file in files:
        name, equals, value = file.partition("=")
        if equals and not os.path.exists(file):
            raise UsageError(
                f"{file}: there is no such file; a xacro argument is written {name}:={value}"
            )
    return tuple(files)


def _arguments(words: Iterable[str]) -> dict[str, str]:
    arguments = {}
    for word in words:
        name, _, value = word.partition(":=")
        if not name:
            raise UsageError(f"'{word}' has no name before ':='")
        arguments[name] = value
    return arguments


def _packages(words: Iterable[str]) -> dict[str, str]:
    packages = {}
    for word in words:
        name, equals, folder = word.partition("=")
        if not (name and equals):
            raise UsageError(f"--package {word}: write the name of the package, '=' and its folder")
        if not os.path.isdir(folder):
            raise UsageError(f"--package {word}: there is no folder '{folder}'")
        packages[name] = folder
    return packages


def _codes(lists: Iterable[str]) -> tuple[str, ...]:
    words = (word.strip() for words in lists for word in words.split(","))
    return tuple(word for word in words if word)


def _outputs(words: Iterable[str], statistics: bool) -> tuple[Output, ...]:
    """The reports that are asked for; statistics take the place of the text for people."""
    from urdfkit import formats

    outputs = []
    for word in words or ("text",):
        name, colon, file = word.partition(":")
        if name not in formats.names():
            raise UsageError(
                f"--format {word}: there is no format '{name}', only {', '.join(formats.names())}"
            )
        if colon and not file:
            raise UsageError(f"--format {word}: write the name of a file after the colon")
        outputs.append(
            Output("statistics" if statistics and name == "text" else name, file or None)
        )
    destinations = [output.file for output in outputs]
    for destination in destinations:
        if destinations.count(destination) > 1:
            where = destination or "standard output"
            raise UsageError(f"two formats for {where}; give one of them a file, as NAME:FILE")
    return tuple(outputs)

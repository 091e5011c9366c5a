"""The table of options of ``urdfkit check``, and the interpretation of their values.

Importing click takes longer than checking a small robot. So ``quick`` parses ordinary command
lines, and click parses all others, including help and errors; both use this table. Other commands
use click only.
"""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfkit.core import disk, expansion_limits
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.errors import UrdfkitError
from urdfkit.output import formats
from urdfkit.workspace.config_file import nearest

if TYPE_CHECKING:
    from urdfkit.lint.config import Config
    from urdfkit.lint.options import Options


class Option(Record):
    """One command-line option."""

    flag: str  # long name, with its dashes
    help: str  # one sentence
    metavar: str = ""  # placeholder of the value in the help; empty for a switch
    choices: tuple[str, ...] = ()  # valid values; any if empty
    many: bool = False  # repeatable
    default: str | None = None  # default of an option with choices
    short: str = ""  # short name, with its dash

    @property
    def key(self) -> str:
        return self.flag[2:].replace("-", "_")

    @property
    def initial(self) -> Any:
        if self.many:
            return ()
        return self.default if self.metavar else False


#: Key of the words that are not options.
FILES = "files"

CHECK = (
    Option(
        "--format",
        "Output format, to FILE or standard output; repeatable. [default: text]",
        "NAME[:FILE]",
        many=True,
    ),
    Option("--output", "File for the format that goes to standard output.", "FILE", short="-o"),
    Option("--quiet", "Print the findings and nothing else.", short="-q"),
    Option(
        "--select", "Run only these rules: codes, prefixes of codes, or names.", "CODES", many=True
    ),
    Option("--ignore", "Do not run these rules.", "CODES", many=True),
    Option(
        "--rules",
        "Also run the rules of these packages: installed names, or modules.",
        "NAMES",
        many=True,
    ),
    Option("--preview", "Run preview rules, too."),
    Option("--simulate", "Also simulate each robot in MuJoCo, for the rules SIM*."),
    Option("--timeout", "Limit of time of one simulation. [default: 300]", "SECONDS"),
    Option("--memory", "Limit of memory with --simulate. [default: 8]", "GIB"),
    Option(
        "--min-confidence",
        "Report only findings of at least this confidence. [default: guessed]",
        "CONFIDENCE",
        ("measured", "inferred", "guessed"),
    ),
    Option(
        "--fail-on",
        "Lowest severity that makes the exit code 1. [default: warning]",
        "SEVERITY",
        ("error", "warning", "info"),
    ),
    Option(
        "--target",
        "Target program, such as moveit or gz-harmonic. [default: detected]",
        "NAMES",
        many=True,
    ),
    Option("--info", "Also show infos, and all details of each finding (--format full)."),
    Option("--watch", "Check again whenever an input file changes, until Ctrl-C."),
    Option(
        "--add-ignore",
        "Write an ignore comment for every finding that decides the exit code; --diff shows them.",
    ),
    Option("--show-files", "List the robots to check and the skipped files; check nothing."),
    Option("--show-settings", "Print the settings of the check as TOML; check nothing."),
    Option("--exit-zero", "Exit with 0 even if there are findings."),
    Option("--fix", "Apply safe fixes in place, and report the remaining findings."),
    Option("--unsafe-fixes", "Also apply fixes that may change the behaviour of the robot."),
    Option("--diff", "Show the fixes as a diff; write nothing."),
    Option("--force", "Also fix files that are generated, git-ignored, read-only, or outside."),
    Option("--statistics", "Print the number of findings by rule instead."),
    Option(
        "--package",
        "Directory of a ROS package; takes precedence over every search.",
        "NAME=DIR",
        many=True,
    ),
    Option("--trust", "Let the model run any expression and read any file."),
    Option("--xacro-seconds", "Processor time of one expansion. [default: 5]", "N"),
    Option("--xacro-megabytes", "Memory of one expansion. [default: 512]", "N"),
    Option("--changed", "FILEs are changed files: check the robots that use them."),
    Option("--no-cache", "Do not read or write the cache."),
    Option("--jobs", "Number of parallel processes. [default: auto]", "N"),
    Option("--config", "Configuration file. [default: the nearest one upwards]", "FILE"),
    Option("--isolated", "Ignore all configuration files."),
    Option("--variant", "Check only this variant of the configuration. [default: all]", "NAME"),
    Option("--baseline", "Do not report findings that are in FILE.", "FILE"),
    Option("--write-baseline", "Write the findings to the baseline, and exit with 0."),
    Option("--stdin-filename", "File name of standard input ('-').", "FILE"),
)

#: The option that all commands have.
COLOR = Option(
    "--color",
    "Colours: auto (on a terminal), always or never.",
    "WHEN",
    ("auto", "always", "never"),
    default="auto",
)


class UsageError(UrdfkitError):
    """The command line is invalid."""


def files(values: Mapping[str, Any]) -> list[str]:
    """The files to check, as typed; '-' is standard input."""
    paths = [word for word in values[FILES] if ":=" not in word]
    if not paths:
        raise UsageError(
            "no file to check; pass a URDF or xacro file, a directory such as '.', or '-' for "
            "standard input"
        )
    if paths.count("-") > 1:
        raise UsageError("'-' stands for standard input, which can be read only once")
    for file in paths:
        name, equals, value = file.partition("=")
        if equals and not disk.exists(file):
            raise UsageError(
                f"{file}: file not found; a xacro argument has the form {name}:={value}"
            )
    return paths


def jobs(values: Mapping[str, Any]) -> int:
    """The number of processes; 0 for ``auto``."""
    word = values["jobs"] or "auto"
    if word == "auto":
        return 0
    if not word.isdecimal() or int(word) < 1:
        raise UsageError(f"--jobs {word}: write a number from 1, or auto")
    return int(word)


def config(values: Mapping[str, Any], near: str) -> Config | None:
    """The configuration of a file; for standard input, of the current directory.

    A configuration that the user did not name may come with the robot, and is not trusted. Sets the
    limits of expansions, from the configuration and the command line.
    """
    configured = _configured(values, near)
    limits = _limits(values)
    if limits:
        from urdfkit.lint.config import Config

        configured = configured or Config()
        configured = configured._replace(limits=configured.limits._replace(**limits))
    if configured is not None:
        expansion_limits.allow(configured.limits)
    return configured


def _limits(values: Mapping[str, Any]) -> dict[str, int]:
    """The limits of an expansion on the command line, by name."""
    limits = {}
    for name in ("seconds", "megabytes"):
        word = values.get(f"xacro_{name}")
        if word is not None:
            if not word.isdecimal() or int(word) < 1:
                raise UsageError(f"--xacro-{name} {word}: write a number from 1")
            limits[name] = int(word)
    return limits


def _configured(values: Mapping[str, Any], near: str) -> Config | None:
    if values["isolated"]:
        return None
    path = values["config"] or nearest(os.curdir if near == "-" else near)
    if path is None:
        return None
    from urdfkit.lint.config_reader import load

    configured = load(path, trusted=bool(values["config"]) or values["trust"])
    for warning in configured.warnings:
        warn(warning)
    return configured


def check_options(values: Mapping[str, Any], file: str) -> Options:
    """The options of a check that all commands with a robot have."""
    from urdfkit.lint.config import Config
    from urdfkit.lint.options import Options

    return Options(
        arguments=arguments(values),
        packages=packages(values),
        targets=words(values, "target") if "target" in values else (),
        trust=values["trust"],
        config=config(values, file) or Config(),
        variant=values["variant"] or "",
    )


def add_rules(values: Mapping[str, Any]) -> list[str]:
    """Register the packages of rules on the command line; their names."""
    names = words(values, "rules")
    if names:
        from urdfkit.lint.rule_packages import add

        add(names, modules=True, directory=os.curdir)
    return names


def arguments(values: Mapping[str, Any]) -> dict[str, str]:
    """The xacro arguments; the last one of a name takes precedence."""
    arguments = {}
    for word in values[FILES]:
        name, is_argument, value = word.partition(":=")
        if is_argument:
            if not name:
                raise UsageError(f"'{word}' has no name before ':='")
            arguments[name] = value
    return arguments


def packages(values: Mapping[str, Any]) -> dict[str, str]:
    directories = {}
    for word in values["package"]:
        name, equals, directory = word.partition("=")
        if not (name and equals):
            raise UsageError(f"--package {word}: expected NAME=DIR: the package and its directory")
        directories[name] = directory
    return directories


def words(values: Mapping[str, Any], key: str) -> list[str]:
    """The words of an option that takes comma-separated lists."""
    return [word.strip() for text in values[key] for word in text.split(",") if word.strip()]


def selected(values: Mapping[str, Any]) -> list[str]:
    """The words of ``--select``; warns of former codes and names."""
    selection = words(values, "select")
    if selection:
        from urdfkit.lint import rule_index

        for note in filter(None, map(rule_index.note, selection)):
            warn(f"--select: {note}")
    return selection


def ignored(values: Mapping[str, Any]) -> list[str]:
    """The words of ``--ignore`` that match a rule; warns of the others."""
    selection = words(values, "ignore")
    if not selection:
        return []
    from urdfkit.lint import rule_index

    errors = rule_index.ignored(selection).unknown
    for note in (*filter(None, map(rule_index.ignore_note, selection)), *errors):
        warn(f"--ignore: {note}")
    unknown = {error.word for error in errors}
    return [word for word in selection if word not in unknown]


def warn(text: str) -> None:
    """Print a warning to standard error; prevents caching, which covers standard output only."""
    disk.depends_on_more()
    from urdfkit.cli import output

    output.log(f"warning: {text}")


def _text(values: Mapping[str, Any], fail_on: str) -> str:
    """The name of the text format."""
    if values["statistics"]:
        return "statistics"
    # With selected rules, or exit code 1 for infos, users need to see infos.
    return "full" if values["info"] or values["select"] or fail_on == "info" else "text"


def outputs(values: Mapping[str, Any], fail_on: str) -> list[tuple[str, str]]:
    """The formats, each with its file; an empty file name stands for standard output."""
    formats_and_files: list[tuple[str, str]] = []
    output_file = "" if values["output"] in (None, "-") else values["output"]
    for word in values["format"] or ("text",):
        name, colon, file = word.partition(":")
        if name not in formats.names():
            known = ", ".join(formats.names())
            raise UsageError(f"--format {word}: unknown format '{name}', only {known}")
        if colon and not file:
            raise UsageError(f"--format {word}: expected a file name after the colon")
        file = "" if file == "-" else file or output_file
        if file in (other for _, other in formats_and_files):
            where = file or "standard output"
            raise UsageError(f"two formats write to {where}; give one of them a file, as NAME:FILE")
        formats_and_files.append((_text(values, fail_on) if name == "text" else name, file))
    if output_file and output_file not in (file for _, file in formats_and_files):
        raise UsageError(f"--output {output_file}: every --format has a file already")
    return formats_and_files

"""The options of ``urdfkit check``, stated once, and what their values mean.

Importing click costs more than checking a small robot. So the ordinary command line is read by
``quick``, and everything else, help and errors included, by click: both from this table, and
both give the same values. Other commands use click alone.
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


class Option(Record):
    """One command-line option."""

    flag: str  # as it is typed
    help: str  # one sentence
    metavar: str = ""  # stands for the value; empty for a switch
    choices: tuple[str, ...] = ()  # the values there are; any if empty
    many: bool = False  # may be given several times
    default: str | None = None  # of an option with choices
    short: str = ""  # the same with one letter

    @property
    def key(self) -> str:
        return self.flag[2:].replace("-", "_")

    @property
    def initial(self) -> Any:
        if self.many:
            return ()
        return self.default if self.metavar else False


#: The name of the value that holds all words that are no options.
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
    Option(
        "--min-confidence",
        "Leave out findings that are less sure. [default: guessed]",
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
    Option("--info", "Show infos, too, and all that is known of each finding (--format full)."),
    Option("--watch", "Check again whenever a file that was read changes, until Ctrl-C."),
    Option(
        "--add-ignore",
        "Write an ignore comment for every finding that decides the exit code; --diff shows them.",
    ),
    Option("--show-files", "List the robots to check and the files left out; check nothing."),
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
    Option(
        "--color",
        "Colours on standard output: auto, always or never.",
        "WHEN",
        ("auto", "always", "never"),
        default="auto",
    ),
    Option("--changed", "FILEs are changed files: check the robots that use them."),
    Option("--no-cache", "Do not read or write the cache."),
    Option("--jobs", "Number of parallel processes. [default: auto]", "N"),
    Option("--config", "Configuration file. [default: the nearest one upwards]", "FILE"),
    Option("--isolated", "Ignore all configuration files."),
    Option("--variant", "Check only this variant of the configuration. [default: all]", "NAME"),
    Option("--baseline", "Do not report findings that are in FILE.", "FILE"),
    Option("--write-baseline", "Write the findings to the baseline, and exit with 0."),
    Option("--stdin-filename", "File name for what '-' reads.", "FILE"),
)


class UsageError(UrdfkitError):
    """The command line is invalid."""


def files(values: Mapping[str, Any]) -> list[str]:
    """The files to check, as typed; '-' is standard input."""
    found = [word for word in values[FILES] if ":=" not in word]
    if not found:
        raise UsageError(
            "no file to check; pass a URDF or xacro file, a directory such as '.', or '-' for "
            "standard input"
        )
    if found.count("-") > 1:
        raise UsageError("'-' stands for standard input, which can be read only once")
    for file in found:
        name, equals, value = file.partition("=")
        if equals and not disk.exists(file):
            raise UsageError(
                f"{file}: file not found; a xacro argument has the form {name}:={value}"
            )
    return found


def jobs(values: Mapping[str, Any]) -> int:
    """The number of processes; 0 for ``auto``."""
    word = values["jobs"] or "auto"
    if word == "auto":
        return 0
    if not word.isdecimal() or int(word) < 1:
        raise UsageError(f"--jobs {word}: write a number from 1, or auto")
    return int(word)


def config(values: Mapping[str, Any], near: str) -> Config | None:
    """The configuration that holds for a file; for standard input that of the current directory.

    One that was found may come with a robot from anywhere, and is no more trusted than it. Its
    limits of an expansion hold from now on, and those that are given.
    """
    found = _configured(values, near)
    given = _limits(values)
    if given:
        from urdfkit.lint.config import Config

        found = found or Config()
        found = found._replace(limits=found.limits._replace(**given))
    if found is not None:
        expansion_limits.allow(found.limits)
    return found


def _limits(values: Mapping[str, Any]) -> dict[str, int]:
    """The limits of an expansion that are given, by name."""
    found = {}
    for name in ("seconds", "megabytes"):
        word = values.get(f"xacro_{name}")
        if word is not None:
            if not word.isdecimal() or int(word) < 1:
                raise UsageError(f"--xacro-{name} {word}: write a number from 1")
            found[name] = int(word)
    return found


def _configured(values: Mapping[str, Any], near: str) -> Config | None:
    if values["isolated"]:
        return None
    path = values["config"] or nearest(os.curdir if near == "-" else near)
    if path is None:
        return None
    from urdfkit.lint.config_reader import load

    found = load(path, trusted=bool(values["config"]) or values["trust"])
    for warning in found.warnings:
        warn(warning)
    return found


def add_rules(values: Mapping[str, Any]) -> list[str]:
    """Packages of rules that are named on the command line; their rules are known from now on."""
    names = words(values, "rules")
    if names:
        from urdfkit.lint.rule_packages import add

        add(names, modules=True, directory=os.curdir)
    return names


def arguments(values: Mapping[str, Any]) -> dict[str, str]:
    """The arguments for xacro; the last of a name wins."""
    found = {}
    for word in values[FILES]:
        name, is_argument, value = word.partition(":=")
        if is_argument:
            if not name:
                raise UsageError(f"'{word}' has no name before ':='")
            found[name] = value
    return found


def packages(values: Mapping[str, Any]) -> dict[str, str]:
    found = {}
    for word in values["package"]:
        name, equals, directory = word.partition("=")
        if not (name and equals):
            raise UsageError(f"--package {word}: expected NAME=DIR: the package and its directory")
        found[name] = directory
    return found


def words(values: Mapping[str, Any], key: str) -> list[str]:
    """The words of an option that takes comma lists."""
    return [word.strip() for text in values[key] for word in text.split(",") if word.strip()]


def selected(values: Mapping[str, Any]) -> list[str]:
    """What ``--select`` names; warns of former codes and names."""
    named = words(values, "select")
    if named:
        from urdfkit.lint import rule_index

        for note in filter(None, map(rule_index.note, named)):
            warn(f"--select: {note}")
    return named


def ignored(values: Mapping[str, Any]) -> list[str]:
    """What ``--ignore`` names; a word that means no rule is warned of and left out."""
    named = words(values, "ignore")
    if not named:
        return []
    from urdfkit.lint import rule_index

    unknown = rule_index.ignored(named).unknown
    for note in (*filter(None, map(rule_index.ignore_note, named)), *unknown):
        warn(f"--ignore: {note}")
    wrong = {error.word for error in unknown}
    return [word for word in named if word not in wrong]


def warn(text: str) -> None:
    """Say on standard error what is odd; the cache of results holds standard output only."""
    disk.depends_on_more()
    from urdfkit.cli import output

    output.tell(f"warning: {text}")


def _text(values: Mapping[str, Any], fail_on: str) -> str:
    """The format of the text for people."""
    if values["statistics"]:
        return "statistics"
    # Whoever names rules, or fails on infos, wants to see what they report.
    return "full" if values["info"] or values["select"] or fail_on == "info" else "text"


def outputs(values: Mapping[str, Any], fail_on: str) -> list[tuple[str, str]]:
    """The formats, each with the file it is for; an empty name is standard output."""
    found: list[tuple[str, str]] = []
    elsewhere = "" if values["output"] in (None, "-") else values["output"]
    for word in values["format"] or ("text",):
        name, colon, file = word.partition(":")
        if name not in formats.names():
            known = ", ".join(formats.names())
            raise UsageError(f"--format {word}: unknown format '{name}', only {known}")
        if colon and not file:
            raise UsageError(f"--format {word}: expected a file name after the colon")
        file = "" if file == "-" else file or elsewhere
        if file in (other for _, other in found):
            where = file or "standard output"
            raise UsageError(f"two formats write to {where}; give one of them a file, as NAME:FILE")
        found.append((_text(values, fail_on) if name == "text" else name, file))
    if elsewhere and elsewhere not in (file for _, file in found):
        raise UsageError(f"--output {elsewhere}: every --format has a file already")
    return found

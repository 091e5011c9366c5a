"""The configuration of a project: ``[tool.urdfkit]`` in pyproject.toml, or ``urdfkit.toml``."""

from __future__ import annotations

import os
from collections.abc import Mapping

from urdfkit.core import disk
from urdfkit.core.expansion_limits import Limits
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.text.diagnostic import Confidence, Severity


class ConfigError(UrdfkitError):
    """The configuration is invalid; the message names the file, the setting and the fix."""


class FileIgnore(Record):
    """Rules that are ignored for some files."""

    files: tuple[str, ...]  # patterns of paths, relative to the configuration's directory
    codes: frozenset[str]  # codes of the ignored rules
    but_errors: frozenset[str]  # codes of the rules whose errors are still reported
    reason: str  # comment for readers of the configuration


class RobotEntry(Record):
    """An entry point: a description to check, with its arguments."""

    file: str  # absolute path
    name: str  # name of the variant; empty if there is only one
    arguments: dict[str, str]  # xacro arguments


class Config(Record):
    """The settings of a project."""

    path: str = ""  # path of the file; empty if there is none
    select: frozenset[str] = frozenset()  # codes of the rules to run; empty for all
    ignore: frozenset[str] = frozenset()  # codes of the rules not to run
    fail_on: Severity = Severity.WARNING  # the lowest severity that makes a check fail
    targets: tuple[str, ...] = ()  # names of targets; detected from each model if empty
    packages: Mapping[str, str] = {}  # absolute directories of packages by name
    arguments: Mapping[str, str] = {}  # arguments of every xacro
    severities: Mapping[str, Severity] = {}  # configured severities by code
    file_ignores: tuple[FileIgnore, ...] = ()
    robots: tuple[RobotEntry, ...] = ()  # the entry points; found by the include graph if empty
    exclude: tuple[str, ...] = ()  # patterns of paths that the check of a directory skips
    external_rules: tuple[str, ...] = ()  # codes of the additional rules of other packages
    preview: bool = False  # True if preview rules run
    named: frozenset[str] = frozenset()  # codes that ``select`` contains as a whole code or name
    min_confidence: Confidence = Confidence.GUESSED  # least confidence of reported findings
    options: Mapping[str, Mapping[str, float]] = {}  # values of options of rules, by code and name
    trust: bool = False  # True if models may run any expression and read any file
    width: int = 0  # columns of a formatted line; 0 for the default
    warnings: tuple[str, ...] = ()  # problems of the configuration that do not affect the check
    but_errors: frozenset[str] = frozenset()  # codes of rules of which only errors are reported
    limits: Limits = Limits()  # limits of the expansion of each description

    @property
    def directory(self) -> str:
        return os.path.dirname(os.path.abspath(self.path)) if self.path else os.getcwd()

    def argument_names(self, path: str) -> frozenset[str]:
        """The names of the arguments of a description and its variants in ``[[robot]]``."""
        real = disk.real(path) if self.robots else ""
        own = (robot.arguments for robot in self.robots if disk.real(robot.file) == real)
        return frozenset().union(*own)

    def entries(
        self, path: str, given: Mapping[str, str] | None = None, variant: str = ""
    ) -> tuple[RobotEntry, ...]:
        """The variants of a description, each with all of its arguments.

        Given arguments override those of the variant, which override those of every xacro. With
        given arguments and no variant the result is one entry, with the arguments that all variants
        share.

        Args:
            variant: the name of one variant; all if empty.

        Raises:
            ConfigError: there is no variant of this name.
        """
        real = disk.real(path)
        own = [robot for robot in self.robots if disk.real(robot.file) == real]
        if variant:
            names = [robot.name for robot in own if robot.name]
            own = [robot for robot in own if robot.name == variant]
            if not own:
                known = f"there are {', '.join(names)}" if names else "it has none"
                raise ConfigError(f"{path}: unknown variant '{variant}'; {known}")
        elif given and len(own) > 1:
            shared = set.intersection(*(set(robot.arguments.items()) for robot in own))
            own = [RobotEntry(path, "", dict(shared))]
        return tuple(
            RobotEntry(path, robot.name, {**self.arguments, **robot.arguments, **(given or {})})
            for robot in own or [RobotEntry(path, "", {})]
        )

    def entry(
        self, path: str, given: Mapping[str, str] | None = None, variant: str = ""
    ) -> RobotEntry:
        """The only variant of a description, see ``entries``.

        Raises:
            ConfigError: there are several variants, or none of this name.
        """
        entries = self.entries(path, given, variant)
        if len(entries) > 1:
            names = ", ".join(robot.name for robot in entries)
            raise ConfigError(f"{path} has several variants: select one with --variant ({names})")
        return entries[0]

    def relative(self, path: str) -> str:
        """A path relative to the configuration, as its patterns match it."""
        return os.path.relpath(os.path.abspath(path), self.directory).replace(os.sep, "/")

    def ignores(self, code: str, path: str, severity: Severity) -> bool:
        """True if findings of a rule with a severity are ignored for a file."""
        is_error = severity is Severity.ERROR
        return (code in self.but_errors and not is_error) or any(
            (code in entry.codes or (code in entry.but_errors and not is_error))
            and matches(self.relative(path), entry.files)
            for entry in self.file_ignores
        )


def matches(path: str, patterns: tuple[str, ...]) -> bool:
    """True if a path or a directory above it matches a pattern.

    ``*`` also matches ``/``, and ``**/`` any number of directories, also none.
    """
    import fnmatch  # not needed if no file is ignored

    written = [pattern.removeprefix("./").rstrip("/") for pattern in patterns]
    written += [pattern.replace("**/", "") for pattern in written if "**/" in pattern]
    return any(
        fnmatch.fnmatchcase(path, pattern) or fnmatch.fnmatchcase(path, f"{pattern}/*")
        for pattern in written
    )

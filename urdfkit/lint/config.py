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
    """Rules that are left out for some files."""

    files: tuple[str, ...]  # patterns of paths, relative to the configuration's directory
    codes: frozenset[str]  # of the rules
    but_errors: frozenset[str]  # of rules whose errors stay
    reason: str  # why, for whoever reads the configuration


class RobotEntry(Record):
    """An entry point: a description that is checked, with the arguments it needs."""

    file: str  # absolute path
    name: str  # of the variant; empty if there is one only
    arguments: dict[str, str]  # for xacro


class Config(Record):
    """The settings of a project."""

    path: str = ""  # of the file; empty if there is none
    #: select and ignore: codes of rules; ``select`` is empty for all.
    select: frozenset[str] = frozenset()
    ignore: frozenset[str] = frozenset()
    fail_on: Severity = Severity.WARNING  # the mildest severity that counts
    targets: tuple[str, ...] = ()  # names of consumers; inferred from each model if empty
    packages: Mapping[str, str] = {}  # directories of packages by name, absolute
    arguments: Mapping[str, str] = {}  # for every xacro
    severities: Mapping[str, Severity] = {}  # other severities by code
    file_ignores: tuple[FileIgnore, ...] = ()  # rules left out for some files
    robots: tuple[RobotEntry, ...] = ()  # the entry points; found by the include graph if empty
    exclude: tuple[str, ...] = ()  # patterns of paths that the check of a directory leaves out
    external_rules: tuple[str, ...] = ()  # codes of the rules of other packages that run, too
    preview: bool = False  # True if preview rules run
    named: frozenset[str] = frozenset()  # codes that ``select`` names by their whole code or name
    min_confidence: Confidence = Confidence.GUESSED  # findings that are less sure are left out
    options: Mapping[str, Mapping[str, float]] = {}  # values of options of rules, by code and name
    trust: bool = False  # True if models may run any expression and read any file
    width: int = 0  # columns of a formatted line; 0 for the default
    #: What is odd about the configuration, and does not change what is checked.
    warnings: tuple[str, ...] = ()
    #: Codes of rules whose findings are left out, but their errors.
    but_errors: frozenset[str] = frozenset()
    limits: Limits = Limits()  # of the expansion of each description

    @property
    def directory(self) -> str:
        return os.path.dirname(os.path.abspath(self.path)) if self.path else os.getcwd()

    def argument_names(self, path: str) -> frozenset[str]:
        """The names of the arguments that ``[[robot]]`` gives to a description and its variants."""
        real = disk.real(path) if self.robots else ""
        own = (robot.arguments for robot in self.robots if disk.real(robot.file) == real)
        return frozenset().union(*own)

    def entries(
        self, path: str, given: Mapping[str, str] | None = None, variant: str = ""
    ) -> tuple[RobotEntry, ...]:
        """The variants of a description, each with all arguments that it is read with.

        Those that are given win over those of the variant, and these over those of every xacro.
        With given arguments and no name it is one description, with what its variants share.

        Args:
            variant: the name of the only one; all if empty.

        Raises:
            ConfigError: there is no variant of this name.
        """
        real = disk.real(path)
        own = [robot for robot in self.robots if disk.real(robot.file) == real]
        if variant:
            names = [robot.name for robot in own if robot.name]
            own = [robot for robot in own if robot.name == variant]
            if not own:
                there = f"there are {', '.join(names)}" if names else "it has none"
                raise ConfigError(f"{path}: unknown variant '{variant}'; {there}")
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
        """The same where one description is wanted.

        Raises:
            ConfigError: there are several, or none of this name.
        """
        found = self.entries(path, given, variant)
        if len(found) > 1:
            names = ", ".join(robot.name for robot in found)
            raise ConfigError(f"{path} has several variants: select one with --variant ({names})")
        return found[0]

    def relative(self, path: str) -> str:
        """A path as the patterns of the configuration see it."""
        return os.path.relpath(os.path.abspath(path), self.directory).replace(os.sep, "/")

    def ignores(self, code: str, path: str, severity: Severity) -> bool:
        """True if findings of a rule with some severity are left out for a file."""
        is_error = severity is Severity.ERROR
        return (code in self.but_errors and not is_error) or any(
            (code in entry.codes or (code in entry.but_errors and not is_error))
            and matches(self.relative(path), entry.files)
            for entry in self.file_ignores
        )


def matches(path: str, patterns: tuple[str, ...]) -> bool:
    """True if a path or a directory above it matches a pattern; ``*`` also matches ``/``."""
    import fnmatch  # not needed where nothing is left out

    return any(
        fnmatch.fnmatchcase(path, pattern) or fnmatch.fnmatchcase(path, f"{pattern.rstrip('/')}/*")
        for pattern in patterns
    )

"""Reads the configuration of a project from pyproject.toml or urdfkit.toml.

An unknown setting is an error that suggests the nearest name: skipping a typo would silently check
something else.
"""

from __future__ import annotations

import os
import sys
from typing import Any

from urdfkit.core import disk
from urdfkit.core.expansion_limits import Limits
from urdfkit.core.paths import is_within, upwards
from urdfkit.errors import RuleError, UnknownRule
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config, ConfigError, FileIgnore, RobotEntry
from urdfkit.lint.settings_table import SettingsTable
from urdfkit.text.diagnostic import Confidence, Severity
from urdfkit.text.source import why_unreadable


def load(path: str, *, trusted: bool = True) -> Config:
    """The configuration in a file.

    Args:
        path: path of the file.
        trusted: False if the file may come with a robot from an untrusted origin. Errors are then:
            settings that could run code (``trust``, and modules in ``rule-packages``), packages and
            robots outside of its workspace, limits above the defaults, and a symbolic link to a
            file outside of its repository.

    Raises:
        ConfigError: the file is missing or has no valid settings.
    """
    if not trusted and disk.is_link(path) and not _is_inside_repository(path):
        raise ConfigError(
            f"{path}: a link to a file outside of the repository; name it by --config"
        )
    table = _table(path)
    if table is None:
        raise ConfigError(f"{path}: no [tool.urdfkit] in this file")
    return _read(_SettingsReader(path, table, "", trusted=trusted), trusted=trusted)


def _is_inside_repository(link: str) -> bool:
    """True if a link's target is in the link's repository, or directory if there is none."""
    directory = os.path.dirname(os.path.abspath(link))
    repositories = (up for up in upwards(directory) if disk.exists(os.path.join(up, ".git")))
    repository = next(repositories, directory)
    return is_within(disk.real(link), disk.real(repository))


def _table(path: str) -> dict[str, Any] | None:
    """urdfkit's settings in a file; None if a pyproject.toml has none."""
    try:
        data = disk.read(path)
    except OSError as error:
        raise ConfigError(f"{path}: {why_unreadable(path, error)}") from error
    own_file = os.path.basename(path) != "pyproject.toml"
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    try:
        document: dict[str, Any] = tomllib.loads(data.decode("utf-8-sig"))
    except (ValueError, RecursionError) as error:  # RecursionError: deeply nested brackets
        raise ConfigError(f"{path}: not TOML: {error}") from error
    if own_file:
        return document
    tools = document.get("tool")
    table = tools.get("urdfkit") if isinstance(tools, dict) else None
    return table if isinstance(table, dict) else None


def _read(reader: _SettingsReader, *, trusted: bool) -> Config:
    external = reader.rule_packages(trusted=trusted)  # first: other settings contain their codes
    ignoring = reader.tables("per-file-ignores")
    select, named = reader.selected()
    ignored = reader.ignored("ignore")
    config = Config(
        reader.path,
        select=select,
        ignore=ignored.codes,
        but_errors=ignored.but_errors,
        fail_on=reader.choice("fail-on", Severity.WARNING),
        targets=reader.targets(),
        packages=reader.packages(),
        arguments=reader.arguments("arguments"),
        severities=reader.severities(),
        file_ignores=tuple(_file_ignore(inner) for inner in ignoring),
        robots=tuple(
            robot for inner in reader.tables("robot") for robot in _robots(inner, reader.directory)
        ),
        exclude=reader.texts("exclude"),
        external_rules=external,
        preview=reader.take("preview", bool, False),
        named=named,
        min_confidence=reader.choice("min-confidence", Confidence.GUESSED),
        options=reader.options(),
        trust=reader.trust(trusted=trusted),
        width=reader.width(),
        limits=reader.limits(trusted=trusted),
    )
    reader.finish()
    warnings = [warning for table in (reader, *ignoring) for warning in table.warnings]
    return config._replace(warnings=tuple(warnings))


def _file_ignore(reader: _SettingsReader) -> FileIgnore:
    files, ignored = reader.texts("files"), reader.ignored("codes")
    reason = str(reader.take("reason", str, ""))
    entry = FileIgnore(files, ignored.codes, ignored.but_errors, reason)
    reader.finish()
    if not entry.files or not (entry.codes or reader.warnings):
        raise reader.error("it needs 'files' and 'codes'")
    return entry


def _robots(reader: _SettingsReader, directory: str) -> list[RobotEntry]:
    """The variants of one entry point, each including the common arguments."""
    name = reader.take("file", str, "")
    common = reader.arguments("arguments")
    variants = reader.take("variants", dict, {})
    reader.finish()
    if not name:
        raise reader.error("it needs 'file'")
    file = os.path.normpath(os.path.join(directory, name))
    reader.require_inside("file", file)
    if not disk.is_file(file):
        raise reader.error(f"file not found: '{file}'")
    if not variants:
        return [RobotEntry(file, "", common)]
    robots = []
    for name, arguments in variants.items():
        where = f"{reader.where}.variants.{name}"
        inner = _SettingsReader(reader.path, {"arguments": arguments}, where, trusted=True)
        robots.append(RobotEntry(file, name, {**common, **inner.arguments("arguments")}))
    return robots


class _SettingsReader(SettingsTable):
    """Reads urdfkit's settings from a table."""

    def width(self) -> int:
        value = self.take("width", int, 0)
        if value and not 40 <= value <= 400:
            raise self.error(f"'width' must be from 40 to 400, not {value}")
        return int(value)

    def rule_packages(self, *, trusted: bool) -> tuple[str, ...]:
        """The codes of the rules of other packages."""
        names = self.texts("rule-packages")
        if not names:
            return ()
        from urdfkit.lint.rule_packages import add

        try:
            return tuple(add(names, modules=trusted, directory=self.directory))
        except RuleError as error:
            raise self.error(f"'rule-packages': {error}") from error

    def trust(self, *, trusted: bool) -> bool:
        value: bool = self.take("trust", bool, False)
        if value and not trusted:
            raise self.error(
                "'trust' must be confirmed on the command line: pass --trust or --config FILE"
            )
        return value

    def limits(self, *, trusted: bool) -> Limits:
        """The limits of an expansion; values above the defaults require a trusted file."""
        defaults = Limits()
        limits = {}
        for name, most in (("seconds", defaults.seconds), ("megabytes", defaults.megabytes)):
            key = f"xacro-{name}"
            value = limits[name] = self.take(key, int, int(most))
            if isinstance(value, bool) or value < 1:
                raise self.error(f"'{key}' must be a whole number from 1, not {value}")
            if value > most and not trusted:
                raise self.error(
                    f"'{key}' above {most:g} must be confirmed on the command line: pass --{key} "
                    "or --config FILE"
                )
        return Limits(**limits)

    def selected(self) -> tuple[frozenset[str], frozenset[str]]:
        """The codes that match the selected words, and those that match a whole code or name."""
        words = self.texts("select")
        codes = frozenset(code for word in words for code in self.matching("select", word))
        return codes, rule_index.named(words)

    def matching(self, key: str, word: str) -> list[str]:
        """The codes that match a word of a setting; warns if the word is a former code."""
        self._note(key, word)
        try:
            return rule_index.matching(word)
        except UnknownRule as error:
            raise self.error(f"'{key}': {error}") from error

    def _note(self, key: str, word: str) -> None:
        if note := rule_index.note(word):
            self.warnings.append(str(self.error(f"'{key}': {note}")))

    def options(self) -> dict[str, dict[str, float]]:
        """The values of options of rules, ``[rules.CODE]``."""
        options: dict[str, dict[str, float]] = {}
        for word, values in self._rules_table().items():
            self._note("rules", word)
            try:
                rule = rule_index.find_rule(word)
            except UnknownRule as error:
                raise self.error(f"'rules': {error}") from error
            if not isinstance(values, dict):
                raise self.error(f"'rules.{word}' must be a table of options, not {values!r}")
            inner = _SettingsReader(self.path, values, f"rules.{word}", trusted=True)
            options[rule.code] = {
                name: inner.number(name, default) for name, default in rule.options.items()
            }
            inner.finish("option")
        return options

    def _rules_table(self) -> dict[str, Any]:
        table = self.take("rules", object, {})
        if not isinstance(table, dict):
            raise self.error(
                "'rules' holds options, as [rules.MSH019]; did you mean 'rule-packages'?"
            )
        return table

    def ignored(self, key: str) -> rule_index.Ignored:
        """The rules to ignore; warns of words that match no rule."""
        words = self.texts(key)
        ignored = rule_index.ignored(words)
        notes = [*filter(None, map(rule_index.ignore_note, words)), *map(str, ignored.unknown)]
        self.warnings += (str(self.error(f"'{key}': {note}")) for note in notes)
        return ignored

    def severities(self) -> dict[str, Severity]:
        table = self.take("severity", dict, {})
        severities: dict[str, Severity] = {}
        for word, value in table.items():
            severity = self.as_choice(Severity, f"severity.{word}", value)
            codes = self.matching("severity", word)
            if rule_index.redirect(word) and severity is not Severity.ERROR:
                # The rule was merged with others, whose errors the user did not mean to lower.
                self.warnings[-1] += ": its severity is not changed"
                continue
            severities.update(dict.fromkeys(codes, severity))
        return severities

    def targets(self) -> tuple[str, ...]:
        from urdfkit.ros.targets import UnknownTarget, parse

        try:
            return parse(self.texts("targets")).names
        except UnknownTarget as error:
            raise self.error(f"'targets': {error}") from error

    def packages(self) -> dict[str, str]:
        table = self.take("packages", dict, {})
        directories = {
            name: os.path.join(self.directory, str(value)) for name, value in table.items()
        }
        for name, directory in directories.items():
            self.require_inside(f"packages.{name}", directory)
            if not disk.is_directory(directory):
                raise self.error(f"'packages.{name}': no such directory '{directory}'")
        return {name: os.path.normpath(directory) for name, directory in directories.items()}

    def require_inside(self, key: str, path: str) -> None:
        """Raise an error for a path outside of the configuration's workspace, unless trusted."""
        if self.trusted:
            return
        from urdfkit.core.paths import is_within
        from urdfkit.workspace.resolve import Resolver

        packages = Resolver().packages
        roots = (packages.workspace(self.path), *packages.prefixes, *packages.ros1_paths)
        if any(is_within(disk.real(path), disk.real(root)) for root in roots):
            return
        raise self.error(
            f"'{key}': '{path}' is outside the workspace of this configuration: "
            "pass --package NAME=DIR, --trust or --config FILE"
        )

    def arguments(self, key: str) -> dict[str, str]:
        """Values as text, like on the command line: ``true``, ``0.5``, ``left_``."""
        table = self.take(key, dict, {})
        for name, value in table.items():
            if not isinstance(value, (str, int, float)):
                raise self.error(f"'{key}.{name}' must be a string, a number or a boolean")
        return {
            name: str(value).lower() if isinstance(value, bool) else str(value)
            for name, value in table.items()
        }

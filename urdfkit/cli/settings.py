"""``urdfkit check --show-settings``: the settings of a check as a configuration."""

import json
import os
from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby

from urdfkit.lint import rule_index
from urdfkit.lint.config import Config, RobotEntry
from urdfkit.lint.options import Options
from urdfkit.text.diagnostic import Severity
from urdfkit.text.editing.formatter import WIDTH
from urdfkit.text.source import shown
from urdfkit.text.terminal import printable, wrap

#: Number of letters of a code that are its family.
_FAMILY = 3


def shown_settings(settings: Options, fail_on: Severity) -> str:
    """The settings of a check as TOML, including those of the command line.

    Args:
        fail_on: the lowest severity that makes the exit code 1.
    """
    return "".join(f"{line}\n" for line in _lines(settings, fail_on))


def _lines(settings: Options, fail_on: Severity) -> Iterator[str]:
    resolved = settings.resolved()
    config = resolved.config
    yield (f"# from {printable(shown(config.path))}" if config.path else "# no configuration file")
    yield wrap(f"select = {_listed(_rules(resolved))}", WIDTH, indent=4)
    yield f"fail-on = {toml_text(fail_on.value)}"
    targets = f"targets = {_listed(resolved.targets)}"
    yield targets if resolved.targets else "# targets: detected for each robot"
    if config.exclude:
        yield f"exclude = {_listed(config.exclude)}"
    yield f"preview = {_value(resolved.preview is True)}"
    yield f"min-confidence = {toml_text(config.min_confidence.value)}"
    yield f"width = {config.width or WIDTH}"
    yield f"xacro-seconds = {config.limits.seconds:g}"
    yield f"xacro-megabytes = {config.limits.megabytes}"
    yield f"trust = {_value(resolved.trust)}"
    directories = {name: os.path.abspath(path) for name, path in resolved.packages.items()}
    yield from _table("packages", directories)
    yield from _table("arguments", {**config.arguments, **settings.arguments})
    yield from _table("severity", {code: level.value for code, level in config.severities.items()})
    for code, options in config.options.items():
        yield from _table(f"rules.{code}", options)
    yield from _of_files(config)
    for file, entries in groupby(config.robots, key=lambda robot: robot.file):
        yield from _robot(file, list(entries))


def _rules(resolved: Options) -> Iterator[str]:
    """The rules that run: families whose rules all run, and codes."""
    selected = set(resolved.select)
    known = sorted({*rule_index.codes(), *rule_index.external()})
    for family, group in groupby(known, key=lambda code: code[:_FAMILY]):
        codes = list(group)
        is_whole = selected.issuperset(codes)
        yield from [family] if is_whole else ()
        for code in filter(selected.__contains__, codes):
            if resolved.previews(code) if rule_index.get(code).preview else not is_whole:
                yield code


def _of_files(config: Config) -> Iterator[str]:
    for entry in config.file_ignores:
        yield ""
        yield "[[per-file-ignores]]"
        yield f"files = {_listed(entry.files)}"
        yield wrap(f"codes = {_listed(sorted(entry.codes | entry.but_errors))}", WIDTH, indent=4)
        if entry.reason:
            yield f"reason = {toml_text(entry.reason)}"


def _robot(file: str, entries: list[RobotEntry]) -> Iterator[str]:
    yield ""
    yield "[[robot]]"
    yield f"file = {toml_text(file)}"
    for entry in entries:
        key = f"variants.{toml_key(entry.name)}" if entry.name else "arguments"
        inner = ", ".join(
            f"{toml_key(name)} = {toml_text(value)}" for name, value in entry.arguments.items()
        )
        yield f"{key} = {{ {inner} }}"


def _table(name: str, values: Mapping[str, object]) -> Iterator[str]:
    if values:
        yield ""
        yield f"[{name}]"
        yield from (f"{toml_key(key)} = {_value(value)}" for key, value in values.items())


def _listed(texts: Iterable[str]) -> str:
    return f"[{', '.join(map(toml_text, texts))}]"


def _value(value: object) -> str:
    """A value in TOML; numbers and booleans are the same as in JSON."""
    return toml_text(value) if isinstance(value, str) else json.dumps(value)


def toml_key(name: str) -> str:
    """A name as a TOML key."""
    is_bare = name.isascii() and name.replace("-", "").replace("_", "").isalnum()
    return name if is_bare else toml_text(name)


def toml_text(text: str) -> str:
    """A string in TOML, with escapes for control sequences of terminals and CI servers."""
    quoted = json.dumps(text, ensure_ascii=False).replace("##", "\\u0023#")
    return "".join(char if char.isprintable() else f"\\U{ord(char):08x}" for char in quoted)

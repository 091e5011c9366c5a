"""Reasons why robots are not checked, with instructions."""

import os
import re
from collections.abc import Iterable, Iterator

from urdfkit.core import disk
from urdfkit.core.paths import upwards
from urdfkit.core.suggest import TYPO
from urdfkit.core.suggest import nearest as nearest_word
from urdfkit.lint.argument_values import found_values, plain_path, reported
from urdfkit.lint.context import Context
from urdfkit.lint.description_file import TOO_EARLY, Reading
from urdfkit.lint.include_graph import INCLUDE
from urdfkit.lint.rule_index import get
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source, shown
from urdfkit.workspace.config_file import nearest
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro


def why_unchecked(reading: Reading, source: Source, resolver: Resolver) -> tuple[str, str]:
    """The reason why a description is not checked, and an instruction."""
    names = tuple(dict.fromkeys(problem.argument for problem in reading.missing_argument_problems))
    if not names or reading.xacro is None:
        errors = (p for p in reading.problems if get(p.code).severity is Severity.ERROR)
        first = next((p for p in errors if p.code != TOO_EARLY), None)
        failure = "cannot be read" if reading.xacro is None else "does not expand"
        why = f"it {failure}" + (f": {first.message} ({first.code})" if first else "")
        return why, f"urdfkit check {shown(source.path)} --select XML,XAC shows the errors"
    candidates = {name: found_values(name, reading.xacro, resolver) for name in names}
    tried = "; ".join(
        f"{name}: {reported(possible)}" for name, possible in candidates.items() if possible
    )
    quoted = ", ".join(f"'{name}'" for name in names)
    why = f"it needs the argument{'s' * (len(names) > 1)} {quoted}"
    why += f" (found for {tried}, with which it does not expand)" if tried else ""
    known = [name for name in names if candidates[name]] + list(reading.defaults)
    for name in names:
        if (
            name not in known
            and not candidates[name]
            and (meant := nearest_word(name, known, TYPO))
        ):
            why += f"; no file gives '{name}' a value: did you mean '{meant}'?"
    config = nearest(source.path)
    directory = os.path.dirname(config) if config else _repository(source.path, resolver)
    file = os.path.relpath(source.path, directory).replace(os.sep, "/")
    values = {
        name: possible.values[0] if possible else "VALUE" for name, possible in candidates.items()
    }
    words = " ".join(f"{name}:={value}" for name, value in values.items())
    lines = ["[[robot]]", f'file = "{file}"']
    lines += [f'arguments.{name} = "{value}"' for name, value in values.items()]
    return why, f"pass {words}, or add to urdfkit.toml: {', '.join(lines)}"


def _repository(path: str, resolver: Resolver) -> str:
    """The repository of a file, which may be one of several in a workspace; else the workspace."""
    workspace = resolver.packages.workspace(path)
    for directory in upwards(os.path.dirname(os.path.abspath(path))):
        if directory == workspace or disk.exists(os.path.join(directory, ".git")):
            return directory
    return workspace


def unread_files(contexts: Iterable[Context]) -> list[str]:
    """The files that descriptions include only with other arguments than those of their checks."""
    read: set[str] = set()
    unread: dict[str, str] = {}  # by real path
    for context in contexts:
        if context.reading.document is not None and context.reading.xacro is not None:
            read.update(disk.real(source.path) for source in context.xacro.sources)
            unread.update(
                (disk.real(path), path) for path in _unread(context.xacro, context.resolver)
            )
    return sorted(path for real, path in unread.items() if real not in read and disk.is_file(path))


def _unread(xacro: Xacro, resolver: Resolver) -> Iterator[str]:
    """The paths without expressions in include tags that were not evaluated."""
    sources = {source.path: source for source in xacro.sources}
    for path, start in xacro.unread_includes:
        if match := re.compile(INCLUDE).match(sources[path].data, start):
            name = match.group(1).decode("utf-8", "replace")
            if file := plain_path(name, sources[path], resolver):
                yield file

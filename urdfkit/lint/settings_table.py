"""Typed access to a table of settings in TOML, with errors that name the file and the setting."""

from __future__ import annotations

import os
import re
from math import inf
from typing import TYPE_CHECKING, Any, TypeVar

from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.config import ConfigError
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from typing_extensions import Self

C = TypeVar("C", Confidence, Severity)

#: Names in messages of the TOML types of settings.
_KINDS = {
    bool: "true or false",
    dict: "a table",
    int: "a whole number",
    list: "a list",
    str: "text",
}


class SettingsTable:
    """Takes settings out of a table one by one; settings left at the end are unknown.

    Args:
        where: the name of the table; empty for the outermost.
        trusted: False if the table may come with a robot from an untrusted origin.
    """

    def __init__(self, path: str, table: dict[str, Any], where: str, *, trusted: bool) -> None:
        self.path = path
        self.trusted = trusted
        self.directory = os.path.dirname(os.path.abspath(path))
        self.where = where
        self.warnings: list[str] = []
        self._left = dict(table)
        self._known: list[str] = []

    def error(self, message: str) -> ConfigError:
        """An error with file, table, and the line of the setting that is quoted first."""
        quoted = re.search(r"'(.+?)'", message)
        line = _line(self.path, self.where, quoted[1] if quoted else "")
        where = f"{self.where}: " if self.where else ""
        return ConfigError(f"{self.path}{f':{line}' if line else ''}: {where}{message}")

    def take(self, key: str, kind: type, default: Any) -> Any:
        """The value of a setting.

        Raises:
            ConfigError: the value has another type.
        """
        self._known.append(key)
        value = self._left.pop(key, default)
        if not isinstance(value, kind):
            hint = f'; write ["{value}"]' if kind is list and isinstance(value, str) else ""
            raise self.error(f"'{key}' must be {_KINDS[kind]}, not {value!r}{hint}")
        return value

    def texts(self, key: str) -> tuple[str, ...]:
        values = self.take(key, list, [])
        for value in values:
            if not isinstance(value, str):
                raise self.error(f"'{key}' must hold strings, not {value!r}")
        return tuple(values)

    def number(self, key: str, default: float) -> float:
        """A number from 0; an integer if the default is an integer."""
        self._known.append(key)
        value = self._left.pop(key, default)
        is_whole = isinstance(default, int)
        is_number = isinstance(value, int if is_whole else (int, float))
        if not is_number or isinstance(value, bool) or not 0 <= value < inf:
            kind = "a whole number" if is_whole else "a number"
            raise self.error(f"'{key}' must be {kind} from 0, not {value!r}")
        return float(value) if not is_whole else int(value)

    def choice(self, key: str, default: C) -> C:
        """A setting whose value is one of an enumeration."""
        return self.as_choice(type(default), key, self.take(key, str, default.value))

    def as_choice(self, kind: type[C], key: str, value: Any) -> C:
        """The member of an enumeration with a value."""
        known = [member.value for member in kind]
        if value not in known:
            raise self.error(f"'{key}' must be one of {', '.join(known)}, not {value!r}")
        return kind(value)

    def tables(self, key: str) -> list[Self]:
        """An array of tables, ``[[key]]``."""
        values = self.take(key, object, [])
        if not (isinstance(values, list) and all(isinstance(value, dict) for value in values)):
            raise self.error(f"'{key}' must be tables, written [[{key}]]")
        return [
            type(self)(self.path, value, f"{key}[{i}]", trusted=self.trusted)
            for i, value in enumerate(values, 1)
        ]

    def finish(self, kind: str = "setting") -> None:
        """Reject settings that were not taken.

        Raises:
            ConfigError: a setting is unknown; the message suggests the nearest name.
        """
        for key in self._left:
            raise self.error(f"unknown {kind} '{key}'{did_you_mean(key, self._known)}")


def _line(path: str, table: str, key: str) -> int:
    """The line of a setting, or of its table if it is missing; 0 if neither is found."""
    array = re.search(r"(.+)\[(\d+)\]", table)
    index = int(array[2]) if array else 0
    setting = ".".join(filter(None, (re.sub(r"\[\d+\]", "", table), key))) + "."
    root = "tool.urdfkit." if os.path.basename(path) == "pyproject.toml" else ""
    section = nearest = ""
    tables = nearest_line = 0
    for number, line in enumerate(disk.read(path).decode(errors="replace").splitlines(), 1):
        text = re.match(r"\s*(\[*)\s*([\w.\"'-]+)\s*[\]=]", line)
        if not text:
            continue
        name = re.sub("[\"']", "", text[2]) + "."
        if text[1]:
            section = name
            tables += bool(array and text[1] == "[[" and name == f"{root}{array[1]}.")
        else:
            name = section + name
        is_parent = f"{root}{setting}".startswith(name)
        if is_parent and len(name) > len(nearest) and tables in (0, index):
            nearest_line, nearest = number, name
    return nearest_line if len(nearest) > len(root) else 0

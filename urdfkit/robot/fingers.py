"""The fingers of a hand: links and joints that are intended to be alike.

Authors write one finger and copy it. Four fingers show which of them differs by mistake.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from urdfkit.core.grouping import by_key
from urdfkit.core.static_typing import TypeVar

T = TypeVar("T")

_FINGER = r"(?i)index|middle|ring(?!er)|pink(?:y|ie)|little"

#: Least number of fingers, of which one may differ from all others.
_MIN_FINGERS = 4

#: Longer names are not compared.
_MAX_LENGTH = 200


def finger_of(name: str) -> str:
    """The word for the finger in a name; empty unless there is one such word."""
    found = re.findall(_FINGER, name) if len(name) <= _MAX_LENGTH else []
    return found[0] if len(found) == 1 else ""


def with_finger(name: str, finger: str) -> str:
    """The name with another finger in the place of its own."""
    return re.sub(_FINGER, finger, name)


def series(names: Iterable[str]) -> list[list[str]]:
    """The names that differ only in the finger, of at least four fingers."""
    groups = by_key((with_finger(name, "*"), name) for name in names if finger_of(name))
    return [group for group in groups.values() if len(group) >= _MIN_FINGERS]


def odd_one(values: Mapping[str, T]) -> tuple[str, T] | None:
    """The only name with another value than all others, and their value; None without one."""
    groups = list(by_key((value, name) for name, value in values.items()).items())
    if len(groups) != 2 or len(values) < _MIN_FINGERS:
        return None
    (_, single), (common, _) = sorted(groups, key=lambda group: len(group[1]))
    return (single[0], common) if len(single) == 1 else None

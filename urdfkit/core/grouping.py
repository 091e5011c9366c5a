"""Values by key, and values whose key an earlier one has."""

from __future__ import annotations

from urdfkit.core.static_typing import TypeVar

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

Key = TypeVar("Key")
Value = TypeVar("Value")


def by_key(pairs: Iterable[tuple[Key, Value]]) -> dict[Key, list[Value]]:
    """The values of each key, in the order of the pairs."""
    groups: dict[Key, list[Value]] = {}
    for key, value in pairs:
        groups.setdefault(key, []).append(value)
    return groups


def repeated(pairs: Iterable[tuple[object, Value]]) -> Iterator[tuple[Value, Value]]:
    """The values whose key an earlier one has, each with the first value of that key.

    >>> list(repeated([("a", "arm"), ("b", "base"), ("a", "axle")]))
    [('axle', 'arm')]
    """
    first: dict[object, Value] = {}
    for key, value in pairs:
        other = first.setdefault(key, value)
        if other is not value:
            yield value, other

"""Entries with a key that another entry has."""

from collections.abc import Iterable, Iterator

from urdfkit.core.static_typing import TypeVar

Entry = TypeVar("Entry")


def repeated(keyed: Iterable[tuple[object, Entry]]) -> Iterator[tuple[Entry, Entry]]:
    """The entries whose key an earlier entry has, each with the first entry of that key.

    >>> list(repeated([("a", "arm"), ("b", "base"), ("a", "axle")]))
    [('axle', 'arm')]
    """
    first: dict[object, Entry] = {}
    for key, entry in keyed:
        other = first.setdefault(key, entry)
        if other is not entry:
            yield entry, other

"""Limits for the size of values of expressions, and how the size is computed."""

from collections.abc import Iterator

from urdfkit.core.static_typing import Any

#: Characters and items of one value; shared parts are counted each time.
MAX_LENGTH = 1_000_000
#: Levels of one value. Python hashes and frees some nested values, and iterators over iterators,
#: by recursion in C, which crashes if it is too deep.
MAX_DEPTH = 100
#: Bits of an integer.
MAX_BITS = 1024
#: Items of a set, and keys of a table.
MAX_HASHED = 10_000
#: Comparisons of hashed values. Items with equal hashes are all compared with each other, which a
#: model can cause with numbers; it cannot choose the hashes of strings.
MAX_COMPARISONS = 100_000
#: Bits of an integer that counts as one item; of a longer integer, every digit counts.
_SMALL_BITS = 64

_SCALARS = frozenset({int, float, bool, type(None)})


class UnsafeExpression(Exception):
    """The expression uses a feature that no model needs."""


class TooLarge(Exception):
    """The value of the expression would be larger than any model needs."""


def extent(value: Any) -> int:
    """Size of a value in characters and items; shared parts are counted each time.

    Raises:
        TooLarge: it is larger than MAX_LENGTH, or nested deeper than MAX_DEPTH.
        UnsafeExpression: it contains an iterator, which could be part of a long chain.
    """
    total = 0
    level = [value]
    for _ in range(MAX_DEPTH):
        inner: list[Any] = []
        for item in level:
            if isinstance(item, (str, bytes)):
                total += len(item)
            elif isinstance(item, int):
                total += digits(item)
            elif isinstance(item, range):
                total += abs(item.stop - item.start) // abs(item.step)
            elif isinstance(item, (dict, list, tuple, set, frozenset, slice)):
                total += _add_parts(item, inner)
            elif isinstance(item, Iterator) and item is not value:
                raise UnsafeExpression("an iterator inside of another value is not allowed")
            check_length(total)
        if not inner:
            return total
        level = inner
    raise TooLarge(f"a value of more than {MAX_DEPTH} levels")


def _add_parts(item: Any, parts: list[Any]) -> int:
    """Append the parts of a value whose size is to be computed; returns the number of all parts."""
    if isinstance(item, dict):
        parts += dict.keys(item)
        parts += dict.values(item)
        if is_namespace(item):
            parts.append(vars(item)["parent"])
        return 2 * len(item)
    if isinstance(item, slice):
        parts += (item.start, item.stop, item.step)
        return 3
    # The base class iterates: xacro's lists of YAML wrap every item.
    items = list(list.__iter__(item) if isinstance(item, list) else item)
    types = set(map(type, items))
    if not types <= _SCALARS:
        parts += items
        return len(items)
    integers = items if types <= {int} else [item for item in items if isinstance(item, int)]
    if max(map(int.bit_length, integers), default=0) <= _SMALL_BITS:
        return len(items)
    return len(items) + sum(map(digits, integers))


def digits(number: int) -> int:
    """The digits of a long integer; 0 for an integer that counts as one item."""
    bits = number.bit_length()
    return bits // 3 if bits > _SMALL_BITS else 0


def is_namespace(table: Any) -> bool:
    """True for a namespace of xacro; its variables are tested, as its attributes are its keys."""
    return "parent" in getattr(table, "__dict__", ())


def materialized(values: Any) -> Any:
    """The values of an iterator as a list; any other value unchanged."""
    return list(values) if isinstance(values, Iterator) else values


def checked_for_hashing(*arguments: Any) -> tuple[Any, ...]:
    """The arguments, after a check that hashing their items does not take too long."""
    arguments = tuple(materialized(values) for values in arguments)
    for values in arguments:
        if hasattr(values, "__len__"):
            check_comparisons(values)
    return arguments


def check_comparisons(values: Any) -> None:
    """Reject items that may take too long to hash."""
    if len(values) > MAX_HASHED:
        raise TooLarge(f"a set or a table of more than {MAX_HASHED} items")
    numbers = [value for value in values if not isinstance(value, str)]
    if len(numbers) * (len(numbers) + extent(numbers)) > 2 * MAX_COMPARISONS:
        raise TooLarge(f"a set or a table of {len(numbers)} items that are not strings")


def check_length(length: int) -> None:
    if length > MAX_LENGTH:
        raise TooLarge(f"a value of {_about(length)} characters or items")


def check_bits(bits: int) -> None:
    if bits > MAX_BITS:
        raise TooLarge(f"an integer of {_about(bits)} bits")


def _about(number: int) -> str:
    return f"{min(number, 10**300):.3g}"  # the largest float

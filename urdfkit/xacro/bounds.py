"""How large a value may be that an expression makes, and how its size is counted."""

from collections.abc import Iterator

from urdfkit.core.static_typing import Any

#: Characters and items of one value, counted as often as they are shared.
MAX_LENGTH = 1_000_000
#: Levels of one value. Python hashes, and lets go of, some nested values by recursion in C,
#: where the end is a crash; the same of iterators over iterators.
MAX_DEPTH = 100
#: Bits of an integer.
MAX_BITS = 1024
#: Items of a set, and keys of a table.
MAX_HASHED = 10_000
#: Comparisons of what is hashed. With equal hashes every item is compared with all others, which
#: a model can bring about with numbers; hashes of texts are no model's to choose.
MAX_COMPARISONS = 100_000
#: Bits of an integer that counts for one item; of a longer one, every character that it shows.
_SMALL_BITS = 64

_SCALARS = frozenset({int, float, bool, type(None)})


class UnsafeExpression(Exception):
    """The expression does what no model needs to do."""


class TooLarge(Exception):
    """The value of the expression would be larger than any model needs."""


def extent(value: Any) -> int:
    """How large a value is: characters and items, counted as often as they are shared.

    Raises:
        TooLarge: it is larger than MAX_LENGTH, or nested more than MAX_DEPTH deep.
        UnsafeExpression: it holds an iterator; of these a chain could be made.
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
    """Add the parts of a value that have an extent of their own; the number of all."""
    if isinstance(item, dict):
        parts += dict.keys(item)
        parts += dict.values(item)
        if is_name_space(item):
            parts.append(vars(item)["parent"])
        return 2 * len(item)
    if isinstance(item, slice):
        parts += (item.start, item.stop, item.step)
        return 3
    # Not by its own iterator: xacro's lists of YAML wrap every item.
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
    """The characters of a long integer; 0 of one that counts as an item."""
    bits = number.bit_length()
    return bits // 3 if bits > _SMALL_BITS else 0


def is_name_space(table: Any) -> bool:
    """True for a name space of xacro; asked of its variables, as it makes keys of attributes."""
    return "parent" in getattr(table, "__dict__", ())


def sized(values: Any) -> Any:
    """The values of an iterator as a list; anything else as it is."""
    return list(values) if isinstance(values, Iterator) else values


def hashed(*arguments: Any) -> tuple[Any, ...]:
    """Arguments whose items may be hashed."""
    arguments = tuple(sized(values) for values in arguments)
    for values in arguments:
        if hasattr(values, "__len__"):
            check_comparisons(values)
    return arguments


def check_comparisons(values: Any) -> None:
    """Refuse items that may take too long to hash."""
    if len(values) > MAX_HASHED:
        raise TooLarge(f"a set or a table of more than {MAX_HASHED} items")
    numbers = [value for value in values if not isinstance(value, str)]
    if len(numbers) * (len(numbers) + extent(numbers)) > 2 * MAX_COMPARISONS:
        raise TooLarge(f"a set or a table of {len(numbers)} items that are no texts")


def check_length(length: int) -> None:
    if length > MAX_LENGTH:
        raise TooLarge(f"a value of {_about(length)} characters or items")


def check_bits(bits: int) -> None:
    if bits > MAX_BITS:
        raise TooLarge(f"an integer of {_about(bits)} bits")


def _about(number: int) -> str:
    return f"{min(number, 10**300):.3g}"  # a float holds no more

"""What the expressions of one expansion may touch, and how much they may make.

``expressions`` rewrites an expression so that every attribute, call and growing operation goes
through the methods here. The invariant: no value that an expression can get hold of is larger
than MAX_LENGTH, however often it shares its parts. So whatever walks over one (``str``, ``==``,
``hash``) is done soon, and what all of them make together the Budget bounds.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from types import BuiltinFunctionType, MethodDescriptorType
from typing import Any

from urdfkit.xacro.budget import STEP_SIZE, Budget

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

#: Types whose methods read or make data, within the bounds of ``call``.
_DATA = (str, int, float, complex, list, tuple, set, frozenset, range, type)
_SCALARS = frozenset({int, float, bool, type(None)})
_HASHING = (dict, set, frozenset)
#: Methods of _DATA that make much of little, or whose argument is a language of its own.
_REFUSED = frozenset(
    "decode encode expandtabs format format_map from_bytes maketrans mro to_bytes translate".split()
)
_OF_TABLES = frozenset(
    "clear copy fromkeys get items keys pop popitem setdefault update values".split()
)
_PADDING = frozenset("center ljust rjust zfill".split())
_GROWING = frozenset("add append extend insert setdefault update".split())
_MAX_FORMAT = 2000
_WIDE_FIELD = r"(?s)%(?:\(.*\))?[#0\- +]*(?:\*|\d{4,}|\d*\.(?:\*|\d{4,}))"


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
                total += _shown(item)
            elif isinstance(item, range):
                total += abs(item.stop - item.start) // abs(item.step)
            elif isinstance(item, (dict, list, tuple, set, frozenset, slice)):
                total += _add_parts(item, inner)
            elif isinstance(item, Iterator) and item is not value:
                raise UnsafeExpression("an iterator inside of another value is not allowed")
            _check_length(total)
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
    if not _SCALARS.issuperset(map(type, items)):
        parts += items
        return len(items)
    return len(items) + sum(_shown(number) for number in items if isinstance(number, int))


def _shown(number: int) -> int:
    """The characters of a long integer."""
    bits = number.bit_length()
    return bits // 3 if bits > _SMALL_BITS else 0


def is_name_space(table: Any) -> bool:
    """True for a name space of xacro; asked of its variables, as it makes keys of attributes."""
    return "parent" in getattr(table, "__dict__", ())


class Sandbox:
    """The guards of one expansion.

    Attributes:
        guards: the functions that rewritten expressions call, by names that no model can give
            to anything, as they hold a space.
    """

    def __init__(self, budget: Budget) -> None:
        self._budget = budget
        self.guards: dict[str, Callable[..., Any]] = {
            "sandbox attribute": self.attribute,
            "sandbox format": self.format,
            "sandbox call": self.call,
            "sandbox keep": self.keep,
            "sandbox hashed": lambda values: _hashed(values)[0],
            "sandbox compared": self.compared,
            "sandbox steps": self.steps,
            "sandbox add": self.add,
            "sandbox times": self.times,
            "sandbox power": self.power,
            "sandbox shift": self.shift,
            "sandbox modulo": self.modulo,
            "sandbox and": lambda left, right: self.keep(left & right),
            "sandbox or": lambda left, right: self.keep(left | right),
            "sandbox xor": lambda left, right: self.keep(left ^ right),
        }
        self._bounded: dict[Any, Callable[..., Any]] = {
            map: self._map,
            filter: self._filter,
            zip: _zip,
            enumerate: lambda values, *start: enumerate(_sized(values), *start),
            sum: self._sum,
            int: _int,
            round: _round,
            math.factorial: _of_small_numbers(math.factorial),
            math.perm: _of_small_numbers(math.perm),
            math.comb: _of_small_numbers(math.comb),
            math.prod: self._product,
            math.lcm: self._multiple,
        }

    def keep(self, value: Any) -> Any:
        """A value that an expression has made, once it is charged for."""
        if isinstance(value, str):
            _check_length(len(value))
            self._budget.charge(len(value))
        elif isinstance(value, int):
            _check_bits(value.bit_length())
            if shown := _shown(value):
                self._budget.charge(shown)
        elif not isinstance(value, float):
            self._budget.charge(extent(value))
        return value

    def compared(self, value: Any) -> Any:
        """A value that is compared, which takes as long as it is large."""
        if isinstance(value, str):
            self._budget.charge(len(value))
        elif not isinstance(value, (int, float)):
            self._budget.charge(extent(value))
        return value

    def steps(self, values: Iterable[Any]) -> Iterator[Any]:
        """The values, each of which is charged for when its turn comes."""
        return self._charged(_sized(values))

    def _charged(self, values: Iterable[Any]) -> Iterator[Any]:
        for value in values:
            self._budget.charge(STEP_SIZE)
            yield value

    def attribute(self, value: Any, name: str) -> Any:
        """An attribute of a value: only data has any."""
        if is_name_space(value):
            if name not in vars(value) and not any(name in vars(k) for k in type(value).__mro__):
                return getattr(value, name)
        elif isinstance(value, dict):
            if name in _OF_TABLES or name not in vars(dict):
                return getattr(value, name)
        else:
            found = getattr(value, name)
            if isinstance(value, _DATA) and name not in _REFUSED and not name.startswith("_"):
                return found
        kind = type(value).__name__
        raise UnsafeExpression(f"attribute '{name}' of a {kind} is not allowed in expressions")

    def format(self, value: Any) -> Any:
        """The attribute ``format`` of a value where it is called: of a text, within bounds."""
        return (
            partial(_format, value) if isinstance(value, str) else self.attribute(value, "format")
        )

    def call(self, function: Any, /, *arguments: Any, **keywords: Any) -> Any:
        """The value of a call, if it can be had within bounds."""
        if callable(keywords.get("key")):
            keywords["key"] = partial(self.call, keywords["key"])
        if isinstance(function, MethodDescriptorType) and arguments:
            bound = function.__get__(arguments[0])
            function, arguments = bound, arguments[1:] if bound is not function else arguments
        if isinstance(function, BuiltinFunctionType):
            owner = function.__self__
            arguments = _within_bounds(owner, function.__name__, arguments)
            if isinstance(owner, (str, list, tuple, set, frozenset)):
                self._budget.charge(extent(owner))  # what a method looks through
        elif isinstance(function, type) and issubclass(function, _HASHING):
            arguments = _hashed(*arguments)
        if isinstance(function, (type, BuiltinFunctionType)):
            function = self._bounded.get(function, function)
        self._budget.charge(STEP_SIZE)
        return self.keep(function(*arguments, **keywords))

    def add(self, left: Any, right: Any) -> Any:
        return self.keep(left + right)

    def times(self, left: Any, right: Any) -> Any:
        if isinstance(left, int) and isinstance(right, int):
            _check_bits(left.bit_length() + right.bit_length() - 1)
        for value, count in ((left, right), (right, left)):
            if isinstance(count, int) and isinstance(value, (str, bytes, list, tuple)):
                _check_length(extent(value) * count)
        return self.keep(left * right)

    def power(self, base: Any, exponent: Any) -> Any:
        if isinstance(base, int) and isinstance(exponent, int) and abs(base) > 1:
            _check_bits((base.bit_length() - 1) * exponent)  # it has at least so many
        return self.keep(base**exponent)

    def shift(self, value: Any, places: Any) -> Any:
        if isinstance(value, int) and isinstance(places, int):
            _check_bits(value.bit_length() + places)
        return self.keep(value << places)

    def modulo(self, left: Any, right: Any) -> Any:
        if isinstance(left, (str, bytes)):
            text = left if isinstance(left, str) else left.decode("latin-1")
            if len(text) > _MAX_FORMAT or re.search(_WIDE_FIELD, text):
                raise TooLarge("a format with a field of more than 999 characters")
            _check_length(text.count("%") * extent(right))
        return self.keep(left % right)

    def _map(self, function: Any, /, *values: Any) -> Iterator[Any]:
        sized = [_sized(one) for one in values]
        return (self.call(function, *arguments) for arguments in zip(*sized))  # noqa: B905

    def _filter(self, function: Any, values: Any, /) -> Iterator[Any]:
        test = bool if function is None else partial(self.call, function)
        return (value for value in self.steps(values) if test(value))

    def _sum(self, values: Any, /, start: Any = 0) -> Any:
        if not isinstance(start, (list, tuple)):
            return sum(self.steps(values), start)
        for value in self.steps(values):
            start = self.add(start, value)
        return start

    def _product(self, values: Any, /, *, start: Any = 1) -> Any:
        for value in self.steps(values):
            start = self.times(start, value)
        return start

    def _multiple(self, *numbers: Any) -> Any:
        least = 1
        for number in numbers:
            least = self.keep(math.lcm(least, number))
        return least


def _format(text: str, /, *arguments: Any, **keywords: Any) -> str:
    """``'...'.format(...)`` of texts and numbers.

    A field that looks into its value, ``{0.a}`` or ``{0[a]}``, gets from any object to all of
    Python, past the guards; one whose width is a field itself may be of any size.
    """
    import string  # few models format

    values = (*arguments, *keywords.values())
    for value in values:
        if value is not None and not isinstance(value, (str, int, float)):
            raise UnsafeExpression(f"a {type(value).__name__} in format() is not allowed")
    widest = max((len(value) for value in values if isinstance(value, str)), default=0)
    count = 0
    for _, field, spec, _ in string.Formatter().parse(text):
        count += 1
        if field and not (field.isidentifier() or field.isdigit()):
            raise UnsafeExpression(f"the field '{{{field}}}' of format() is not allowed")
        if spec and re.search(r"[{}]|\d{4,}", spec):
            raise UnsafeExpression(f"the width '{spec}' in format() is not allowed")
    _check_length(count * (1000 + 10 * widest))
    return str.format(text, *arguments, **keywords)


def _within_bounds(owner: Any, name: str, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """The arguments of a built-in method, once its result is known to be small enough."""
    if isinstance(owner, str):
        if name == "join":
            arguments = tuple(_sized(value) for value in arguments)
        for value in arguments:
            if hasattr(value, "__len__"):
                _check_length((len(owner) + 1) * len(value) // 10)
            elif name in _PADDING and isinstance(value, int):
                _check_length(value)
    elif isinstance(owner, _HASHING) or name == "fromkeys":
        arguments = _hashed(*arguments)
    elif name in _GROWING:
        arguments = tuple(_sized(value) for value in arguments)
    if name in _GROWING and isinstance(owner, (list, set, dict)):
        _check_length(extent(owner) + sum(extent(value) for value in arguments))
        if not isinstance(owner, list):
            _check_comparisons([*owner, *arguments])
    return arguments


def _sized(values: Any) -> Any:
    """The values of an iterator as a list; anything else as it is."""
    return list(values) if isinstance(values, Iterator) else values


def _zip(*values: Any, strict: bool = False) -> Iterator[Any]:
    return zip(*map(_sized, values), strict=strict)


def _hashed(*arguments: Any) -> tuple[Any, ...]:
    """Arguments whose items may be hashed."""
    arguments = tuple(_sized(values) for values in arguments)
    for values in arguments:
        if hasattr(values, "__len__"):
            _check_comparisons(values)
    return arguments


def _check_comparisons(values: Any) -> None:
    """Refuse items that may take too long to hash."""
    if len(values) > MAX_HASHED:
        raise TooLarge(f"a set or a table of more than {MAX_HASHED} items")
    numbers = [value for value in values if not isinstance(value, str)]
    if len(numbers) * (len(numbers) + extent(numbers)) > 2 * MAX_COMPARISONS:
        raise TooLarge(f"a set or a table of {len(numbers)} items that are no texts")


def _int(*arguments: Any, **keywords: Any) -> int:
    for value in arguments[:1]:
        if isinstance(value, (str, bytes)):
            _check_bits(4 * len(value))
    return int(*arguments, **keywords)


def _round(number: Any, ndigits: Any = None) -> Any:
    if isinstance(ndigits, int):
        _check_bits(4 * abs(ndigits))
    return round(number, ndigits)


def _of_small_numbers(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function of combinatorics, whose value has so many bits."""

    def bounded(*numbers: Any) -> Any:
        for number in numbers:
            if isinstance(number, int):
                _check_bits(10 * abs(number))
        return function(*numbers)

    return bounded


def _check_length(length: int) -> None:
    if length > MAX_LENGTH:
        raise TooLarge(f"a value of {_about(length)} characters or items")


def _check_bits(bits: int) -> None:
    if bits > MAX_BITS:
        raise TooLarge(f"an integer of {_about(bits)} bits")


def _about(number: int) -> str:
    return f"{min(number, 10**300):.3g}"  # a float holds no more

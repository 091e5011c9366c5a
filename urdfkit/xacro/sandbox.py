"""Access and size limits for the expressions of an expansion.

``expressions`` rewrites an expression so that every attribute, call and growing operation goes
through the methods here. The invariant: no value in an expression is larger than MAX_LENGTH, with
shared parts counted each time. So operations on one value (``str``, ``==``, ``hash``) are fast, and
the Budget limits all values together.
"""

import math
import re
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from types import BuiltinFunctionType, MethodDescriptorType

from urdfkit.core.static_typing import Any
from urdfkit.xacro.bounds import (
    TooLarge,
    UnsafeExpression,
    check_bits,
    check_comparisons,
    check_length,
    checked_for_hashing,
    digits,
    extent,
    is_namespace,
    materialized,
)
from urdfkit.xacro.budget import STEP_SIZE, Budget

#: Types whose methods read or create data, within the limits of ``call``.
_DATA = (str, int, float, complex, list, tuple, set, frozenset, range, type)
_HASHING = (dict, set, frozenset)
#: Methods of _DATA whose result may be large, or whose argument is a language of its own.
_FORBIDDEN = frozenset(
    "decode encode expandtabs format format_map from_bytes maketrans mro to_bytes translate".split()
)
_TABLE_METHODS = frozenset(
    "clear copy fromkeys get items keys pop popitem setdefault update values".split()
)
_PADDING = frozenset("center ljust rjust zfill".split())
_GROWING = frozenset("add append extend insert setdefault update".split())
_MAX_FORMAT = 2000
_WIDE_FIELD = r"(?s)%(?:\(.*\))?[#0\- +]*(?:\*|\d{4,}|\d*\.(?:\*|\d{4,}))"


class Sandbox:
    """The guards of one expansion."""

    def __init__(self, budget: Budget) -> None:
        self._budget = budget
        #: The functions that rewritten expressions call; their names contain a space, so that no
        #: model can use them.
        self.guards: dict[str, Callable[..., Any]] = {
            "sandbox attribute": self.attribute,
            "sandbox format": self.format,
            "sandbox call": self.call,
            "sandbox charged": self.charged,
            "sandbox hashed": lambda values: checked_for_hashing(values)[0],
            "sandbox compared": self.compared,
            "sandbox steps": self.steps,
            "sandbox add": self.add,
            "sandbox times": self.times,
            "sandbox power": self.power,
            "sandbox shift": self.shift,
            "sandbox modulo": self.modulo,
            "sandbox and": lambda left, right: self.charged(left & right),
            "sandbox or": lambda left, right: self.charged(left | right),
            "sandbox xor": lambda left, right: self.charged(left ^ right),
        }
        self._bounded: dict[Any, Callable[..., Any]] = {
            map: self._map,
            filter: self._filter,
            zip: _zip,
            enumerate: lambda values, *start: enumerate(materialized(values), *start),
            sum: self._sum,
            int: _int,
            round: _round,
            math.factorial: _of_small_numbers(math.factorial),
            math.perm: _of_small_numbers(math.perm),
            math.comb: _of_small_numbers(math.comb),
            math.prod: self._product,
            math.lcm: self._multiple,
        }

    def charged(self, value: Any) -> Any:
        """A value that an expression created, after it is charged to the budget."""
        if isinstance(value, str):
            check_length(len(value))
            self._budget.charge(len(value))
        elif isinstance(value, int):
            check_bits(value.bit_length())
            if shown := digits(value):
                self._budget.charge(shown)
        elif not isinstance(value, float):
            self._budget.charge(extent(value))
        return value

    def compared(self, value: Any) -> Any:
        """A value that is compared, after it is charged: the time depends on its size."""
        if isinstance(value, str):
            self._budget.charge(len(value))
        elif not isinstance(value, (int, float)):
            self._budget.charge(extent(value))
        return value

    def steps(self, values: Iterable[Any]) -> Iterator[Any]:
        """The values of an iteration, each charged when it is used."""
        return self._charged(materialized(values))

    def _charged(self, values: Iterable[Any]) -> Iterator[Any]:
        for value in values:
            self._budget.charge(STEP_SIZE)
            yield value

    def attribute(self, value: Any, name: str) -> Any:
        """An attribute of a value; only attributes of data are allowed."""
        if is_namespace(value):
            if name not in vars(value) and not any(name in vars(k) for k in type(value).__mro__):
                return getattr(value, name)
        elif isinstance(value, dict):
            if name in _TABLE_METHODS or name not in vars(dict):
                return getattr(value, name)
        else:
            attribute = getattr(value, name)
            if isinstance(value, _DATA) and name not in _FORBIDDEN and not name.startswith("_"):
                return attribute
        kind = type(value).__name__
        raise UnsafeExpression(f"attribute '{name}' of a {kind} is not allowed in expressions")

    def format(self, value: Any) -> Any:
        """The called method ``format`` of a value; that of a text is limited."""
        return (
            partial(_format, value) if isinstance(value, str) else self.attribute(value, "format")
        )

    def call(self, function: Any, /, *arguments: Any, **keywords: Any) -> Any:
        """The value of a call, within the limits."""
        if callable(keywords.get("key")):
            keywords["key"] = partial(self.call, keywords["key"])
        if isinstance(function, MethodDescriptorType) and arguments:
            bound = function.__get__(arguments[0])
            function, arguments = bound, arguments[1:] if bound is not function else arguments
        if isinstance(function, BuiltinFunctionType):
            owner = function.__self__
            arguments = _checked_arguments(owner, function.__name__, arguments)
            if isinstance(owner, (str, list, tuple, set, frozenset)):
                self._budget.charge(extent(owner))  # which a method may search
        elif isinstance(function, type) and issubclass(function, _HASHING):
            arguments = checked_for_hashing(*arguments)
        if isinstance(function, (type, BuiltinFunctionType)):
            function = self._bounded.get(function, function)
        self._budget.charge(STEP_SIZE)
        return self.charged(function(*arguments, **keywords))

    def add(self, left: Any, right: Any) -> Any:
        return self.charged(left + right)

    def times(self, left: Any, right: Any) -> Any:
        if isinstance(left, int) and isinstance(right, int):
            check_bits(left.bit_length() + right.bit_length() - 1)
        for value, count in ((left, right), (right, left)):
            if isinstance(count, int) and isinstance(value, (str, bytes, list, tuple)):
                check_length(extent(value) * count)
        return self.charged(left * right)

    def power(self, base: Any, exponent: Any) -> Any:
        if isinstance(base, int) and isinstance(exponent, int) and abs(base) > 1:
            check_bits((base.bit_length() - 1) * exponent)  # a lower bound
        return self.charged(base**exponent)

    def shift(self, value: Any, places: Any) -> Any:
        if isinstance(value, int) and isinstance(places, int):
            check_bits(value.bit_length() + places)
        return self.charged(value << places)

    def modulo(self, left: Any, right: Any) -> Any:
        if isinstance(left, (str, bytes)):
            text = left if isinstance(left, str) else left.decode("latin-1")
            if len(text) > _MAX_FORMAT or re.search(_WIDE_FIELD, text):
                raise TooLarge("a format with a field of more than 999 characters")
            check_length(text.count("%") * extent(right))
        return self.charged(left % right)

    def _map(self, function: Any, /, *values: Any) -> Iterator[Any]:
        columns = map(materialized, values)
        return (self.call(function, *arguments) for arguments in zip(*columns))  # noqa: B905

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
            least = self.charged(math.lcm(least, number))
        return least


def _format(text: str, /, *arguments: Any, **keywords: Any) -> str:
    """``'...'.format(...)`` of texts and numbers.

    A field with an attribute or item, ``{0.a}`` or ``{0[a]}``, bypasses the guards and gives access
    to all of Python; a field whose width is a field may have any size.
    """
    import string  # needed only by few models

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
    check_length(count * (1000 + 10 * widest))
    return str.format(text, *arguments, **keywords)


def _checked_arguments(owner: Any, name: str, arguments: tuple[Any, ...]) -> tuple[Any, ...]:
    """The arguments of a built-in method, after a check of the size of its result."""
    if isinstance(owner, str):
        if name == "join":
            arguments = tuple(map(materialized, arguments))
        for value in arguments:
            if hasattr(value, "__len__"):
                check_length((len(owner) + 1) * len(value) // 10)
            elif name in _PADDING and isinstance(value, int):
                check_length(value)
    elif isinstance(owner, _HASHING) or name == "fromkeys":
        arguments = checked_for_hashing(*arguments)
    elif name in _GROWING:
        arguments = tuple(map(materialized, arguments))
    if name in _GROWING and isinstance(owner, (list, set, dict)):
        check_length(extent(owner) + sum(extent(value) for value in arguments))
        if not isinstance(owner, list):
            check_comparisons([*owner, *arguments])
    return arguments


def _zip(*values: Any, strict: bool = False) -> Iterator[Any]:
    return zip(*map(materialized, values), strict=strict)


def _int(*arguments: Any, **keywords: Any) -> int:
    for value in arguments[:1]:
        if isinstance(value, (str, bytes)):
            check_bits(4 * len(value))
    return int(*arguments, **keywords)


def _round(number: Any, ndigits: Any = None) -> Any:
    if isinstance(ndigits, int):
        check_bits(4 * abs(ndigits))
    return round(number, ndigits)


def _of_small_numbers(function: Callable[..., Any]) -> Callable[..., Any]:
    """A function of combinatorics, limited by an estimate of the bits of its value."""

    def bounded(*numbers: Any) -> Any:
        for number in numbers:
            if isinstance(number, int):
                check_bits(10 * abs(number))
        return function(*numbers)

    return bounded

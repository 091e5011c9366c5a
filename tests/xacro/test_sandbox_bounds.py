"""The bounds of the sandbox: what is as large as allowed is made, and nothing larger."""

from collections.abc import Callable
from math import comb, factorial, inf, lcm, prod
from typing import Any

import pytest
import xacro

from urdfkit.text.source import Source
from urdfkit.text.xml_reader import DocumentTooLarge
from urdfkit.xacro import sandbox as module
from urdfkit.xacro.bounds import TooLarge, UnsafeExpression, extent
from urdfkit.xacro.budget import Budget, deadline
from urdfkit.xacro.dom_builder import parse
from urdfkit.xacro.sandbox import Sandbox, _checked_arguments


def sandbox() -> Sandbox:
    return Sandbox(Budget(inf))


def nested(levels: int) -> list[Any]:
    value: list[Any] = []
    for _ in range(levels - 1):
        value = [value]
    return value


#: What makes a value of a size, and the largest size.
LARGEST: dict[str, tuple[Callable[[int], object], int]] = {
    "a text": (lambda n: sandbox().charged("a" * n), 1_000_000),
    "two texts": (lambda n: sandbox().charged(["a" * (n - 100), "b" * 98]), 1_000_000),
    "a shared text": (lambda n: sandbox().charged(["a" * n] * 10), 99_999),
    "a range": (lambda n: sandbox().charged(range(n)), 1_000_000),
    "a range of steps": (lambda n: sandbox().charged(range(0, 7 * n, 7)), 1_000_000),
    "a table": (lambda n: extent(dict.fromkeys(range(n))), 500_000),
    "levels": (lambda n: extent(nested(n)), 100),
    "a sum of texts": (lambda n: sandbox().add("a" * 10, "a" * (n - 10)), 1_000_000),
    "a repeated text": (lambda n: sandbox().times("ab", n), 500_000),
    "a power": (lambda n: sandbox().power(2, n), 1_023),
    "a shift": (lambda n: sandbox().shift(1, n), 1_023),
    "a shift of a large number": (lambda n: sandbox().shift(2**999, n), 24),
    "a factorial": (lambda n: sandbox().call(factorial, n), 102),
    "digits": (lambda n: sandbox().call(int, "f" * n, 16), 256),
    "rounding": (lambda n: sandbox().call(round, 1, -n), 256),
    "a set": (lambda n: sandbox().call(set, range(n)), 316),
    "keys": (lambda n: sandbox().call(dict.fromkeys, range(n)), 316),
    "keys that are texts": (lambda n: sandbox().call(set, list(map(str, range(n)))), 10_000),
    "a set of tuples": (lambda n: sandbox().call(set, [(0,) * 98 + (i,) for i in range(n)]), 44),
    "a set that grows": (lambda n: sandbox().call(set(range(n - 1)).add, -1), 316),
    "a product": (lambda n: sandbox().times(2**1000, 2 ** (n - 1)), 24),
    "long integers": (lambda n: sandbox().charged([2**1000] * n), 2_994),
    "center": (lambda n: sandbox().call("a".center, n), 1_000_000),
    "ljust": (lambda n: sandbox().call("a".ljust, n), 1_000_000),
    "rjust": (lambda n: sandbox().call("a".rjust, n), 1_000_000),
    "zfill": (lambda n: sandbox().call("a".zfill, n), 1_000_000),
    "ljust of the class": (lambda n: sandbox().call(str.ljust, "a", n), 1_000_000),
    "a list that grows": (lambda n: sandbox().call([0].extend, [0] * (n - 1)), 1_000_000),
    "fields": (lambda n: sandbox().modulo("%s" * 500, ("a" * (n - 499), *"b" * 499)), 1_500),
}


@pytest.mark.parametrize("what", LARGEST)
def test_a_value_as_large_as_allowed(what: str) -> None:
    make, largest = LARGEST[what]
    make(largest)
    with pytest.raises(TooLarge):
        make(largest + 1)


@pytest.mark.parametrize("method", ["center", "ljust", "rjust", "zfill"])
def test_padding_is_refused_before_it_is_made(method: str) -> None:
    assert _checked_arguments("a", method, (1_000_000,)) == (1_000_000,)
    with pytest.raises(TooLarge):
        _checked_arguments("a", method, (1_000_001,))


class Unasked(int):
    """A number that nobody may compute with."""

    def refuse(self, other: Any, *_: Any) -> Any:
        pytest.fail("it is made, and looked at afterwards")

    __pow__ = __mul__ = __lshift__ = refuse


@pytest.mark.parametrize(
    ("operation", "left", "right"),
    [("power", 2**63, 17), ("times", 2**1000, 2**40), ("shift", 1, 1024)],
)
def test_a_long_integer_is_refused_before_it_is_made(operation: str, left: int, right: int) -> None:
    with pytest.raises(TooLarge):
        getattr(sandbox(), operation)(Unasked(left), right)


def test_a_method_of_a_class_has_the_bounds_of_its_object(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[Any, ...]] = []

    def within_bounds(*call: Any) -> Any:
        asked.append(call)
        return call[2]

    monkeypatch.setattr(module, "_checked_arguments", within_bounds)
    assert sandbox().call(str.ljust, "a", 3) == "a  "
    assert asked == [("a", "ljust", (3,))]


@pytest.mark.parametrize("value", ["a", 1, [], (), {1}, int])
def test_what_begins_with_an_underscore_is_no_data(value: object) -> None:
    with pytest.raises(UnsafeExpression):
        sandbox().attribute(value, "__class__")


def test_fields_of_three_digits() -> None:
    assert len(sandbox().modulo("%999d", 1)) == 999
    with pytest.raises(TooLarge):
        sandbox().modulo("%1000d", 1)
    assert len(sandbox().call(sandbox().format("{:999}"), 1)) == 999
    with pytest.raises(UnsafeExpression):
        sandbox().call(sandbox().format("{:1000}"), 1)


def test_fields_of_format_count_for_1000_letters_and_10_of_each_of_the_longest_text() -> None:
    def formatted(fields: int, value: object) -> object:
        return sandbox().call(sandbox().format("{0}" * fields), value)

    assert formatted(1000, 7) == "7" * 1000
    assert formatted(500, "a" * 100) == "a" * 50_000
    for fields, value in ((1001, 7), (501, "a" * 100), (500, "a" * 101)):
        with pytest.raises(TooLarge):
            formatted(fields, value)


def test_the_budget_of_one_expansion() -> None:
    budget = Budget(inf)
    budget.charge(512 * 60_000)
    budget.charge(999)
    with pytest.raises(DocumentTooLarge):
        budget.charge(1)  # it looks no more often


def test_the_time_of_one_expansion(monkeypatch: pytest.MonkeyPatch) -> None:
    """It looks at the clock once in 1000 units."""
    now, looks = 7.0, 0

    def clock() -> float:
        nonlocal looks
        looks += 1
        return now

    monkeypatch.setattr("urdfkit.xacro.budget._clock", clock)
    budget = Budget(deadline())
    now, looks = 12.0, 0
    for _ in range(1, 5000):
        budget.charge(1)
    assert looks == 5
    now = 12.001
    with pytest.raises(DocumentTooLarge, match="longer than 5 s"):
        budget.charge(2)


class Charged(Budget):
    """A budget that remembers what was charged."""

    def __init__(self) -> None:
        super().__init__(inf)
        self.units: list[int] = []

    def charge(self, units: int) -> None:
        self.units.append(units)


def name_space(parent: Any, **names: Any) -> Any:
    found = xacro.NameSpace(parent)
    found.update(names)
    return found


#: Values, and for how many characters and items each is charged.
CHARGED: dict[str, tuple[Any, int]] = {
    "a text": ("abc", 3),
    "a list": (["abc", (1, 2)], 7),
    "a range": (range(9), 9),
    "a table": ({"k": "ab"}, 5),
    "a slice": (slice(1, 2), 3),
    "a name space": (name_space(None, a="xyz"), 6),
    "a name space and what it leads to": (name_space({"k": "abc"}, a="xyz"), 12),
}


@pytest.mark.parametrize("what", CHARGED)
def test_what_is_made_is_charged_for_with_all_that_it_holds(what: str) -> None:
    value, units = CHARGED[what]
    budget = Charged()
    assert Sandbox(budget).charged(value) is value
    assert budget.units == [units]


def test_steps_and_elements_count_for_many_characters() -> None:
    budget = Charged()
    assert Sandbox(budget).call(abs, -1) == 1
    assert list(Sandbox(budget).steps([1, 2])) == [1, 2]
    parse(Source("r.xacro", b"<a/>"), None, budget)
    assert budget.units == [10, 10, 10, len("<a/>"), 100]


@pytest.mark.parametrize(
    ("function", "arguments"),
    [
        (round, (2.567, 1)),
        (int, ("ff", 16)),
        (sum, ([1, 2],)),
        (sum, ([[1], [2]], [])),
        (prod, ([2, 3],)),
        (lcm, (4, 6)),
        (comb, (5, 2)),
        (factorial, (5,)),
    ],
    ids=lambda value: getattr(value, "__name__", None),
)
def test_within_the_bounds_a_function_gives_what_it_gives_in_python(
    function: Callable[..., Any], arguments: tuple[Any, ...]
) -> None:
    assert sandbox().call(function, *arguments) == function(*arguments)

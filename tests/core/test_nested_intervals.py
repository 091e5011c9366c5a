"""Nested intervals: found by position as by looking at each."""

from collections.abc import Iterator
from random import Random

import pytest

from urdfkit.core.nested_intervals import NestedIntervals


def elements(random: Random, start: int, end: int) -> Iterator[tuple[int, int]]:
    """Random intervals of a document; some elements have several, as comments before them have."""
    while end - start > 1:
        start += random.randint(0, 3)
        stop = min(end, start + random.randint(1, 60))
        if start >= stop:
            return
        yield from [(start, stop)] * random.randint(1, 3)
        yield from elements(random, start + 1, stop - 1)
        start = stop


@pytest.mark.parametrize("seed", range(20))
def test_values_around_a_position(seed: int) -> None:
    random = Random(seed)
    intervals = [(*ends, number) for number, ends in enumerate(elements(random, 0, 300))]
    assert len(intervals) > 20
    random.shuffle(intervals)
    nested = NestedIntervals(intervals)
    for position in range(-1, 302):
        expected = {number for start, end, number in intervals if start <= position < end}
        found = nested.around(position)
        assert set(found) == expected
        assert len(found) == len(expected)


def test_no_intervals() -> None:
    assert NestedIntervals[str]([]).around(0) == []

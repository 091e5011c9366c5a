"""Intervals that are nested or disjoint, such as elements of a document, found by position."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable

from urdfkit.core.static_typing import Generic, TypeVar

T = TypeVar("T")


class NestedIntervals(Generic[T]):
    """Values of intervals, found in time of the depth of nesting.

    Args:
        intervals: start, end (exclusive) and value of each.
    """

    __slots__ = ("_intervals", "_outer", "_starts")

    def __init__(self, intervals: Iterable[tuple[int, int, T]]) -> None:
        self._intervals = sorted(intervals, key=lambda interval: (interval[0], -interval[1]))
        self._starts = [start for start, _, _ in self._intervals]
        self._outer: list[int] = []  # number of the interval around each, or -1
        outer = -1
        for number, (start, _, _) in enumerate(self._intervals):
            while outer >= 0 and self._intervals[outer][1] <= start:
                outer = self._outer[outer]
            self._outer.append(outer)
            outer = number

    def around(self, position: int) -> list[T]:
        """The values of the intervals that contain a position, from the inside out."""
        number = bisect_right(self._starts, position) - 1
        values: list[T] = []
        while number >= 0:
            _, end, value = self._intervals[number]
            if position < end:
                values.append(value)
            number = self._outer[number]
        return values

"""Threads for bands of an image; results do not depend on their number."""

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

from urdfkit.core import limits

T = TypeVar("T")

#: More threads would wait for each other.
MAX_THREADS = 8


class Workers:
    """Threads that process bands of rows; numpy allows them to run in parallel.

    Args:
        threads: number of threads; None for the number of processors.
    """

    def __init__(self, threads: int | None = None) -> None:
        self.threads = threads or min(MAX_THREADS, limits.processors())

    def each(self, things: Sequence[T], work: Callable[[T], object]) -> None:
        """Call ``work(thing)`` for each thing."""
        if self.threads == 1 or len(things) == 1:
            for thing in things:
                work(thing)
            return
        with ThreadPoolExecutor(self.threads) as pool:
            for _ in pool.map(work, things):
                pass

    def bands(self, rows: int, height: int, work: Callable[[int, int], None]) -> None:
        """Call ``work(first, last)`` for all bands of a height; the last row is excluded."""
        edges = [(first, min(first + height, rows)) for first in range(0, rows, height)]
        self.each(edges, lambda edge: work(*edge))

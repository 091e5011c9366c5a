"""Bands of a picture on several threads; what they do does not depend on their number."""

from __future__ import annotations

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

#: More threads than this wait for one another.
MAX_THREADS = 8


class Workers:
    """Threads that work on bands of rows; numpy lets them run side by side.

    Args:
        threads: how many; as many as there are processors if None.
    """

    def __init__(self, threads: int | None = None) -> None:
        self.threads = threads or min(MAX_THREADS, _processors())

    def bands(self, rows: int, height: int, work: Callable[[int, int], None]) -> None:
        """Call ``work(first, last)`` for all bands of some height; the last row is excluded."""
        edges = [(first, min(first + height, rows)) for first in range(0, rows, height)]
        if self.threads == 1 or len(edges) == 1:
            for first, last in edges:
                work(first, last)
            return
        with ThreadPoolExecutor(self.threads) as pool:
            for _ in pool.map(lambda edge: work(*edge), edges):
                pass


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1

"""That work grows like its input: never by seconds, which are the machine's affair."""

import sys
import time
from collections.abc import Callable
from types import FrameType
from typing import Any

#: How much larger the large input is: linear work grows as much, quadratic work by its square.
FACTOR = 400


def assert_linear(work: Callable[[int], Callable[[], object]], size: int) -> None:
    """Work on an input of a size takes at most 20 times its share of that on the 400th part.

    For work of regular expressions and of libraries in C. Quadratic work takes 400 times its share.

    Args:
        work: prepares the work on an input of a size; only what it returns is measured.
        size: of the large input.
    """
    small = min(_processor_time(work(size // FACTOR)) for _ in range(5))
    # Other processes take the cache of the processor: one of three runs counts.
    assert any(_processor_time(work(size)) < 20 * FACTOR * small for _ in range(3))


def _processor_time(run: Callable[[], object]) -> float:
    start = time.process_time()
    run()
    return time.process_time() - start


def executed_lines(run: Callable[[], object]) -> int:
    """How many lines of Python a call executes: the same number in each run."""
    count = 0

    def trace(frame: FrameType, event: str, argument: Any) -> Any:
        nonlocal count
        count += event == "line"
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        run()
    finally:
        sys.settrace(before)
    return count

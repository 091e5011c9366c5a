"""Limits of time and memory for an expansion, enforced by the operating system.

The sandbox limits each operation in advance, and checks the time between operations. Here the
system interrupts an expansion that takes too long or too much memory, so that operations which the
sandbox does not check are limited, too. Signals reach only the main thread; in other threads, only
the sandbox applies.
"""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

from urdfkit.core import expansion_limits
from urdfkit.xacro.budget import Budget

#: Seconds until the interruption is repeated, if the first exception is caught.
_REPEAT_SECONDS = 0.1


@contextmanager
def watched(budget: Budget) -> Iterator[None]:
    """Limit the time and memory of a ``with`` block.

    Raises:
        DocumentTooLarge: it takes too long.
        MemoryError: it takes too much memory.
    """
    stop_clock = _start_timer(budget)
    if stop_clock is None:
        yield
        return
    allow_memory = _limit_memory(expansion_limits.allowed().megabytes)
    try:
        yield
    finally:
        stop_clock()
        allow_memory()


def _start_timer(budget: Budget) -> Callable[[], None] | None:
    """Let the system interrupt this thread at the deadline.

    Returns:
        A function that stops the timer; None if this is not the main thread, or the system has no
        such timers.
    """
    if sys.platform in {"win32", "emscripten"}:
        return None
    import signal

    def interrupt(_: int, __: FrameType | None) -> None:
        budget.check_time()

    try:
        previous = signal.signal(signal.SIGVTALRM, interrupt)
    except ValueError:  # not the main thread
        return None
    signal.setitimer(signal.ITIMER_VIRTUAL, budget.seconds_left(), _REPEAT_SECONDS)

    def stop() -> None:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, previous or signal.SIG_DFL)

    return stop


def _limit_memory(megabytes: int) -> Callable[[], None]:
    """Limit the growth of this process; returns a function that removes the limit."""
    if sys.platform != "linux":  # other systems do not report their size, or have no such limit
        return lambda: None
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = _address_space() + megabytes * 2**20
    if soft != resource.RLIM_INFINITY and soft <= most:
        return lambda: None
    resource.setrlimit(resource.RLIMIT_AS, (most, hard))
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def _address_space() -> int:
    """Size of the address space of this process, in bytes."""
    with open("/proc/self/statm", "rb") as file:
        return int(file.read().split()[0]) * os.sysconf("SC_PAGESIZE")

"""The limits of an expansion, kept by the system, whatever the expansion is doing.

The sandbox bounds each operation beforehand, and looks at the clock between two of them. Here the
system interrupts what takes too long and refuses memory to what takes too much, so that an
operation that the sandbox does not know is bounded, too. Signals reach the main thread only; in
other threads, as in the language server, the sandbox is alone.
"""

import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType

from urdfkit.core import expansion_limits
from urdfkit.xacro.budget import Budget

#: Seconds between two interruptions, if something catches the first.
_AGAIN = 0.1


@contextmanager
def watched(budget: Budget) -> Iterator[None]:
    """Bound what is done in a ``with`` statement by time and memory.

    Raises:
        DocumentTooLarge: it takes too long.
        MemoryError: it takes too much memory.
    """
    stop_clock = _interrupt_late(budget)
    if stop_clock is None:
        yield
        return
    allow_memory = _refuse_memory(expansion_limits.allowed().megabytes)
    try:
        yield
    finally:
        stop_clock()
        allow_memory()


def _interrupt_late(budget: Budget) -> Callable[[], None] | None:
    """Let the system interrupt this thread when its time is over; what is returned ends that.

    None if the thread is not the main one, or there are no such timers.
    """
    if sys.platform in {"win32", "emscripten"}:
        return None
    import signal

    def interrupt(_: int, __: FrameType | None) -> None:
        budget.check_time()

    try:
        before = signal.signal(signal.SIGVTALRM, interrupt)
    except ValueError:  # not the main thread
        return None
    signal.setitimer(signal.ITIMER_VIRTUAL, budget.seconds_left(), _AGAIN)

    def stop() -> None:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before or signal.SIG_DFL)

    return stop


def _refuse_memory(megabytes: int) -> Callable[[], None]:
    """Let this process grow by so much; what is returned lifts the limit."""
    if sys.platform != "linux":  # others cannot say how large they are, or keep no such limit
        return lambda: None
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_AS)
    most = _address_space() + megabytes * 2**20
    if soft != resource.RLIM_INFINITY and soft <= most:
        return lambda: None
    resource.setrlimit(resource.RLIMIT_AS, (most, hard))
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (soft, hard))


def _address_space() -> int:
    """The bytes of address space that this process has."""
    with open("/proc/self/statm", "rb") as file:
        return int(file.read().split()[0]) * os.sysconf("SC_PAGESIZE")

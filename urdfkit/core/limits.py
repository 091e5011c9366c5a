"""Limits of a process that computes: processors, memory, and time until it begins to write.

A process that another one waits for (`urdfkit.cli.own_process`) tells it where it is when it ends.
"""

from __future__ import annotations

from errno import ENOMEM

TYPE_CHECKING = False

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress

#: Bytes: what a library may have asked for in vain, in one piece, when something fails.
_MARGIN = 128 * 2**20

#: To the process that waits for this one; -1 if none does.
_channel = -1


def answer_to(channel: int) -> None:
    """Tell a process how far this one is, and where it crashes or is stopped.

    Args:
        channel: the descriptor of a pipe that the other process reads.
    """
    import faulthandler

    global _channel  # noqa: PLW0603 - a process answers to one other
    _channel = channel
    faulthandler.enable(channel, all_threads=False)


def is_answering() -> bool:
    """True if another process waits for this one."""
    return _channel >= 0


def begin_time(seconds: float) -> None:
    """End this process after so many seconds; nothing happens if no other process waits for it.

    A thread of C does it, which no loop in native code holds up.
    """
    if is_answering():
        import faulthandler

        _report(f"limit {seconds:g} s")
        faulthandler.dump_traceback_later(seconds, exit=True, file=_channel)
        _limit_processor_time(seconds)


def end_time() -> None:
    """What is written is written whole, however long it takes."""
    if is_answering():
        import faulthandler

        faulthandler.cancel_dump_traceback_later()


def begin_memory(size: int) -> None:
    """`limit_memory`, if another process waits for this one."""
    if is_answering():
        limit_memory(size)


def limit_memory(size: int) -> None:
    """Limit the address space of this process, and let a crash leave no core behind.

    Args:
        size: in bytes. Windows has no such limit.
    """
    try:
        import resource
    except ImportError:  # Windows
        return
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    most = resource.getrlimit(resource.RLIMIT_AS)[1]
    if most != resource.RLIM_INFINITY:
        size = min(size, most)
    resource.setrlimit(resource.RLIMIT_AS, (size, most))


def lacks_memory(error: BaseException) -> bool:
    """True if an error, whatever it is called, comes from a lack of memory.

    Near the limit of a process, imports, threads and libraries fail in ways of their own.
    """
    cause: BaseException | None = error
    while cause is not None:
        if isinstance(cause, MemoryError) or getattr(cause, "errno", None) == ENOMEM:
            return True
        cause = cause.__cause__ or cause.__context__
    return _room() < _MARGIN


def _room() -> float:
    """Bytes between the most address space that this process has had and its limit."""
    try:
        import resource

        most = resource.getrlimit(resource.RLIMIT_AS)[0]
        if most != resource.RLIM_INFINITY:
            with open("/proc/self/status", "rb") as file:
                (peak,) = (line.split()[1] for line in file if line.startswith(b"VmPeak:"))
            return most - int(peak) * 1024
    except (ImportError, OSError, ValueError):  # not Linux
        pass
    return float("inf")


def noting(progress: Progress | None) -> Progress | None:
    """Progress that the process that waits for this one learns of, too."""
    if not is_answering():
        return progress

    def noted(done: int, total: int) -> None:
        _report(f"done {done} of {total}" if total else f"done {done}")
        if progress:
            progress(done, total)

    return noted


def processors() -> int:
    """How many processors this process may use; a container or ``taskset`` leaves it fewer."""
    import os

    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _limit_processor_time(seconds: float) -> None:
    """Processes that this one starts inherit it, and end if this one leaves them behind."""
    import resource

    most = resource.getrlimit(resource.RLIMIT_CPU)[1]
    allowed = int(seconds + 2) * processors()
    if most == resource.RLIM_INFINITY or allowed < most:
        resource.setrlimit(resource.RLIMIT_CPU, (allowed, most))


def _report(text: str) -> None:
    import os

    try:
        os.write(_channel, f"{text}\n".encode())
    except OSError:
        pass  # nobody waits any more

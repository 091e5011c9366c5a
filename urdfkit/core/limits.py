"""Limits of a computing process: processors, memory, and time until it begins to write.

A supervised process (`urdfkit.cli.own_process`) reports its progress, and where it was when it
ended, to its supervisor.
"""

from __future__ import annotations

from errno import ENOMEM

TYPE_CHECKING = False

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress

#: Bytes: with less than this left, a failure is attributed to a lack of memory.
_MARGIN = 128 * 2**20

#: Pipe to the supervisor; -1 without one.
_channel = -1


def answer_to(channel: int) -> None:
    """Report progress, crashes and timeouts of this process to its supervisor.

    Args:
        channel: descriptor of a pipe that the supervisor reads.
    """
    import faulthandler

    global _channel  # noqa: PLW0603 - a process has one supervisor
    _channel = channel
    faulthandler.enable(channel, all_threads=False)


def is_answering() -> bool:
    """True if this process is supervised."""
    return _channel >= 0


def begin_time(seconds: float) -> None:
    """End this process after a time; no effect without a supervisor.

    A thread of faulthandler ends it, which native code cannot block.
    """
    if is_answering():
        import faulthandler

        _report(f"limit {seconds:g} s")
        faulthandler.dump_traceback_later(seconds, exit=True, file=_channel)
        _limit_processor_time(seconds)


def end_time() -> None:
    """Remove the time limit, so that results are written completely."""
    if is_answering():
        import faulthandler

        faulthandler.cancel_dump_traceback_later()


def begin_memory(size: int) -> None:
    """`limit_memory`, if this process is supervised."""
    if is_answering():
        limit_memory(size)


def limit_memory(size: int) -> None:
    """Limit the address space of this process, and disable core dumps.

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
    """True if an error of any type is due to a lack of memory.

    Near the limit, imports, threads and libraries fail with errors of various types.
    """
    cause: BaseException | None = error
    while cause is not None:
        if isinstance(cause, MemoryError) or getattr(cause, "errno", None) == ENOMEM:
            return True
        cause = cause.__cause__ or cause.__context__
    return _room() < _MARGIN


def _room() -> float:
    """Bytes between the peak address space of this process and its limit."""
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
    """A progress callback that reports to the supervisor, too."""
    if not is_answering():
        return progress

    def report_both(done: int, total: int) -> None:
        _report(f"done {done} of {total}" if total else f"done {done}")
        if progress:
            progress(done, total)

    return report_both


def processors() -> int:
    """Number of processors that this process may use; containers and ``taskset`` limit it."""
    import os

    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _limit_processor_time(seconds: float) -> None:
    """Limit CPU time from now on; child processes inherit the limit, so that orphans end."""
    import resource

    most = resource.getrlimit(resource.RLIMIT_CPU)[1]
    used = resource.getrusage(resource.RUSAGE_SELF)
    allowed = int(used.ru_utime + used.ru_stime) + int(seconds + 2) * processors()
    if most == resource.RLIM_INFINITY or allowed < most:
        resource.setrlimit(resource.RLIMIT_CPU, (allowed, most))


def _report(text: str) -> None:
    import os

    try:
        os.write(_channel, f"{text}\n".encode())
    except OSError:
        pass  # the supervisor has ended

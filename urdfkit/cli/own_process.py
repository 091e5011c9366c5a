"""Runs a command line in its own process, which a library may crash and a limit may end.

The parent process then reports an error in one line. The process is forked before anything large is
imported. Windows cannot fork: there the command runs in the same process, without limits.
"""

from __future__ import annotations

import os
import re
import signal
import time

from urdfkit.core import limits

TYPE_CHECKING = False

if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import NoReturn

#: Seconds that a stopped process has to remove incomplete files.
_LAST_SECONDS = 2.0
#: The last message of a process that ends normally.
_END = b"end\n"
#: A line of a traceback of faulthandler.
_FRAME = re.compile(r'File "([^"]*)", line \d+ in (\S+)')


class _Stopped(Exception):
    """The process received SIGTERM."""


def run_forked(run: Callable[[], int], leave: Callable[[int], NoReturn]) -> int:
    """The exit code of a function, which runs in its own process.

    Args:
        leave: ends that process with an exit code.
    """
    lifeline, own_end = os.pipe()
    reports, reporting = os.pipe()
    process = os.fork()
    if process == 0:
        os.close(own_end)
        os.close(reports)
        _depend_on(lifeline)
        limits.answer_to(reporting)
        code = run()
        os.write(reporting, _END)
        leave(code)
    os.close(lifeline)
    os.close(reporting)
    signal.signal(signal.SIGTERM, _stop)
    try:
        messages = _read(reports)
        status = os.waitpid(process, 0)[1]
    except (KeyboardInterrupt, _Stopped) as error:
        os.close(own_end)  # ends the process, see _depend_on
        _await_end(process)
        return 130 if isinstance(error, KeyboardInterrupt) else 143
    return _code(status, messages)


def _stop(number: int, frame: object) -> NoReturn:
    signal.signal(number, signal.SIG_IGN)  # `timeout` sends it again, to the process group
    raise _Stopped


def _interrupt(number: int, frame: object) -> NoReturn:
    signal.signal(number, signal.SIG_IGN)
    raise KeyboardInterrupt


def _depend_on(lifeline: int) -> None:
    """End this process when its parent ends for any reason."""
    from _thread import start_new_thread

    def watch() -> None:
        os.read(lifeline, 1)  # returns when the other end is closed
        os.kill(os.getpid(), signal.SIGTERM)

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the parent handles Ctrl-C
    signal.signal(signal.SIGTERM, _interrupt)
    start_new_thread(watch, ())


def _read(pipe: int) -> str:
    """All messages of the process, until it ends."""
    parts = []
    while part := os.read(pipe, 65536):
        parts.append(part)
    return b"".join(parts).decode("utf-8", "replace")


def _await_end(process: int) -> None:
    end = time.monotonic() + _LAST_SECONDS
    while time.monotonic() < end:
        if os.waitpid(process, os.WNOHANG)[0]:
            return
        time.sleep(0.01)
    os.kill(process, signal.SIGKILL)
    os.waitpid(process, 0)


def _code(status: int, messages: str) -> int:
    """The exit code of a process that has ended; prints the reason if it ended abnormally."""
    from urdfkit.cli import fail

    if os.WIFEXITED(status) and messages.endswith(_END.decode()):
        return os.WEXITSTATUS(status)
    where = _where(messages)
    if "Timeout (" in messages:
        limit = re.findall(r"^limit (.*)$", messages, re.MULTILINE)[-1]
        return fail(2, f"not finished after {limit}{where}; --timeout raises the limit")
    if os.WIFEXITED(status):
        return fail(2, f"a library ended the process{where}; perhaps memory ran out")
    number = os.WTERMSIG(status)
    name = signal.Signals(number).name
    if number == signal.SIGKILL:
        return fail(2, f"the process was killed ({name}){where}; perhaps memory ran out")
    return fail(2, f"a library crashed ({name}){where}")


def _where(messages: str) -> str:
    """The progress of the process, and the function of urdfkit in which it ended, if known."""
    counts = re.findall(r"^done (.*)$", messages, re.MULTILINE)
    progress = f": {counts[-1]} done" if counts else ""
    main_thread = re.split("hread 0x", messages)[-1]  # faulthandler lists it last
    for path, function in _FRAME.findall(main_thread):
        _, package, module = path.replace(os.sep, "/").rpartition("/urdfkit/")
        if package:
            name = module.removesuffix(".py").removesuffix("/__init__").replace("/", ".")
            return f"{progress}, in urdfkit.{name}.{function}"
    return progress

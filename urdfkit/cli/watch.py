"""``urdfkit check --watch``: check again whenever an input of the check changes.

The inputs are the files and directories that the check reads, searches or lists, including missing
files. They are logged like for the result cache (`core/file_log.py`).
"""

import multiprocessing
import os
import sys
import time
from collections.abc import Callable, Mapping
from multiprocessing.connection import Connection
from typing import Any, TypeAlias

from urdfkit.cli import guarded, options, output
from urdfkit.core import disk
from urdfkit.core.file_log import FileLog, present_answers
from urdfkit.core.words import counted
from urdfkit.errors import UrdfkitError

#: Seconds between two polls of the files.
EVERY = 0.3

#: Kind, path and answer of each query of a check, and its start in nanoseconds since the epoch.
_Queries: TypeAlias = "tuple[list[tuple[str, str, str]], int]"
#: Runs a check with the values of a command line, and returns its exit code.
Check: TypeAlias = "Callable[[Mapping[str, Any]], int]"


def watch(check: Check, values: Mapping[str, Any]) -> int:
    """Check until Ctrl-C.

    Raises:
        UsageError: for standard input, or options that change files.
        KeyboardInterrupt: Ctrl-C.
    """
    if "-" in options.files(values):
        raise options.UsageError("--watch needs files, not standard input")
    if any(values[key] for key in ("fix", "add_ignore", "write_baseline")):
        raise options.UsageError("--watch cannot be combined with options that change files")
    while True:
        if sys.stdout is not None and sys.stdout.isatty():
            output.write("\x1b[2J\x1b[H")
        answers, since = _checked(check, {**values, "watch": False})
        files = {path for kind, path, _ in answers if kind[0] == "r"}
        output.note(f"watching {counted(len(files), 'file')}; Ctrl-C ends")
        while (unchanged := present_answers(answers, since)) is not None:
            answers, since = unchanged, time.time_ns()
            time.sleep(EVERY)


def _checked(check: Check, values: Mapping[str, Any]) -> _Queries:
    """Check in a new process, so that no state is kept between checks."""
    context: Any = multiprocessing.get_context("fork" if hasattr(os, "fork") else "spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_check, args=(check, values, output.used_color(), sender))
    process.start()
    sender.close()
    try:
        queries: _Queries = receiver.recv()
    except EOFError as error:
        process.join()
        if process.exitcode:
            raise UrdfkitError(f"the check crashed (exit code {process.exitcode})") from error
        raise KeyboardInterrupt from error
    process.join()
    return queries


def _check(check: Check, values: Mapping[str, Any], color: str, sender: Connection) -> None:
    output.use_color(color)
    log, since = FileLog(), time.time_ns()
    disk.log_to(log)
    if guarded(lambda _: check(values), []) != 130:
        answers = [(kind, path, answer) for (kind, path), answer in log.answers.items()]
        sender.send((answers, since))

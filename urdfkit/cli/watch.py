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
from urdfkit.core.file_log import FileLog, WatchedFiles
from urdfkit.core.words import counted
from urdfkit.errors import UrdfkitError

#: Seconds between two polls of the files.
EVERY = 0.3

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
        files = _checked(check, {**values, "watch": False})
        output.note(f"watching {counted(files.count, 'file')}; Ctrl-C ends")
        while not files.have_changed:
            time.sleep(EVERY)


def _checked(check: Check, values: Mapping[str, Any]) -> WatchedFiles:
    """Check in a new process, so that no state is kept between checks; returns its inputs."""
    context: Any = multiprocessing.get_context("fork" if hasattr(os, "fork") else "spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_check, args=(check, values, output.used_color(), sender))
    process.start()
    sender.close()
    try:
        files: WatchedFiles = receiver.recv()
    except EOFError as error:
        process.join()
        if process.exitcode:
            raise UrdfkitError(f"the check crashed (exit code {process.exitcode})") from error
        raise KeyboardInterrupt from error
    process.join()
    return files


def _check(check: Check, values: Mapping[str, Any], color: str, sender: Connection) -> None:
    output.use_color(color)
    log, since = FileLog(), time.time_ns()
    disk.log_to(log)
    if guarded(lambda _: check(values), []) != 130:
        sender.send(WatchedFiles(log, since))

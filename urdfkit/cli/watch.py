"""``urdfkit check --watch``: check again whenever something that the check read changes.

What a check reads, looks for and lists is noted as for the cache of results (`core/file_log.py`),
files that are missing included. That is what is watched, and nothing else.
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

#: Seconds between two looks at the files.
EVERY = 0.3

#: Kind, path and answer of what a check has asked, and nanoseconds since the epoch before it did.
_Asked: TypeAlias = "tuple[list[tuple[str, str, str]], int]"
#: Prints what is wrong with the values of a command line; its exit code.
Check: TypeAlias = "Callable[[Mapping[str, Any]], int]"


def watch(check: Check, values: Mapping[str, Any]) -> int:
    """Check until Ctrl-C.

    Raises:
        UsageError: of standard input, or of a check that changes files.
        KeyboardInterrupt: Ctrl-C.
    """
    if "-" in options.files(values):
        raise options.UsageError("--watch takes files, not standard input")
    if any(values[key] for key in ("fix", "add_ignore", "write_baseline")):
        raise options.UsageError("--watch takes no option that changes files")
    while True:
        if sys.stdout is not None and sys.stdout.isatty():
            output.write("\x1b[2J\x1b[H")
        answers, since = _checked(check, {**values, "watch": False})
        files = {path for kind, path, _ in answers if kind[0] == "r"}
        output.note(f"watching {counted(len(files), 'file')}; Ctrl-C ends")
        while (again := present_answers(answers, since)) is not None:
            answers, since = again, time.time_ns()
            time.sleep(EVERY)


def _checked(check: Check, values: Mapping[str, Any]) -> _Asked:
    """Check in a process of its own, which keeps nothing from one check to the next."""
    context: Any = multiprocessing.get_context("fork" if hasattr(os, "fork") else "spawn")
    receiver, sender = context.Pipe(duplex=False)
    process = context.Process(target=_check, args=(check, values, sender))
    process.start()
    sender.close()
    try:
        asked: _Asked = receiver.recv()
    except EOFError as error:
        process.join()
        if process.exitcode:
            raise UrdfkitError(f"the check has died (exit code {process.exitcode})") from error
        raise KeyboardInterrupt from error
    process.join()
    return asked


def _check(check: Check, values: Mapping[str, Any], sender: Connection) -> None:
    log, since = FileLog(), time.time_ns()
    disk.log_to(log)
    if guarded(lambda _: check(values), []) != 130:
        answers = [(kind, path, answer) for (kind, path), answer in log.answers.items()]
        sender.send((answers, since))

"""The results of earlier checks, which an unchanged check repeats.

An entry is a file named after the question: the command line, the working directory, the
environment of the terminal, and the versions of urdfkit, Python and the installed packages. It
holds what the check asked of the file system and of the environment, with the answers
(`core/file_log.py`), and what it printed. An entry of which an answer has changed, that is
damaged, or that answers another question is as good as none.

This module runs before anything else is imported, and imports next to nothing.
"""

import os
import sys
import time
from zlib import crc32

from urdfkit import __version__
from urdfkit.cli.result_entry import ResultEntry, decode, directory, path_of
from urdfkit.core import file_log
from urdfkit.core.regular_file import opened

_STANDARD_LIBRARY = os.path.dirname(os.__file__)
#: Variables that decide how a result is printed.
_OF_THE_TERMINAL = ("COLUMNS", "FORCE_COLOR", "NO_COLOR", "TERM", "URDFKIT_DEBUG")


def question(words: list[str]) -> bytes | None:
    """What a command line asks, as far as it is known before a file is read.

    None if it cannot be answered from the cache.
    """
    if words[:1] != ["check"] or directory() is None:
        return None
    if not {"--no-cache", "--watch", "-"}.isdisjoint(words):
        return None
    try:
        here = os.getcwd()
    except OSError:  # the current directory is gone
        return None
    parts = [__version__, __file__, sys.version, here, str(len(words)), *words, *_terminal()]
    parts += [f"{place} {_installed(place or os.curdir)}" for place in sys.path]
    return b"\0".join(map(os.fsencode, parts))


def _installed(place: str) -> int:
    """What changes with every package that is installed, removed or replaced in a place."""
    try:
        time_of_change = os.stat(place).st_mtime_ns
        if place.endswith("-packages") or place.startswith(_STANDARD_LIBRARY):
            return time_of_change
        # Other directories hold more than packages: a checkout, scripts, the working directory.
        names = sorted(filter(_is_of_package, os.listdir(place)))
    except NotADirectoryError:  # an archive
        return time_of_change
    except OSError:
        return 0
    return crc32("\0".join(names).encode("utf-8", "surrogateescape"))


def _is_of_package(name: str) -> bool:
    return "." not in name or name.endswith((".py", ".so", ".pyd", "-info"))


def _terminal() -> list[str]:
    """What decides how standard output is written."""
    values = [f"{name}={os.environ.get(name)}" for name in _OF_THE_TERMINAL]
    if sys.stdout is None or not sys.stdout.isatty():
        return values
    try:
        size = os.get_terminal_size(sys.stdout.fileno()).columns
    except (OSError, ValueError):
        size = 0
    return [*values, f"{sys.stdout.encoding} {size}"]


def replay(words: list[str]) -> int | None:
    """Repeat an earlier check and return its exit code; None if nothing is known of it."""
    asked = question(words)
    if asked is None or sys.stdout is None:
        return None
    try:
        with opened(path_of(asked)) as file:
            entry = decode(file.read())
    except (OSError, ValueError):
        return None
    if entry.question != asked:
        return None
    now = time.time_ns()
    answers = file_log.present_answers(entry.answers, entry.since)
    if answers is None:
        return None
    if answers != entry.answers:
        from urdfkit.cli.result_recording import store

        # Files have new times, as git gives them. The next check need not compare contents.
        store(entry._replace(since=now, answers=answers))
    return _write(entry)


def _write(entry: ResultEntry) -> int:
    for path, data in entry.outputs:
        if path:
            from urdfkit.core import atomic

            atomic.write(path, data)
            continue
        try:
            sys.stdout.buffer.write(data)
            sys.stdout.flush()
        except OSError as error:
            from urdfkit.cli.output import give_up

            give_up(error)
    return entry.code

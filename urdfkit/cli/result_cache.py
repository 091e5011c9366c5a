"""Cache of check results: an unchanged check replays its earlier output.

An entry is a file named by a checksum of the key: the command line, the working directory, the
terminal's variables, and the versions of urdfkit, Python and the installed packages. It contains
the queries of the check to the file system and the environment, with their answers
(`core/file_log.py`), and the output. An entry is ignored if an answer has changed, if it is
damaged, or if it is for another key.

This module is imported first, and imports as little as possible.
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
#: Environment variables that affect the output.
_OF_THE_TERMINAL = ("COLUMNS", "FORCE_COLOR", "NO_COLOR", "TERM", "URDFKIT_DEBUG")


def cache_key(words: list[str]) -> bytes | None:
    """The inputs of a command line that are known before files are read, as a cache key.

    None if its result is not cached.
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
    """A number that changes with every installed, removed or replaced package in a directory."""
    try:
        time_of_change = os.stat(place).st_mtime_ns
        if place.endswith("-packages") or place.startswith(_STANDARD_LIBRARY):
            return time_of_change
        # Other directories do not only contain packages: a checkout, scripts, the working directory
        names = sorted(filter(_is_of_package, os.listdir(place)))
    except NotADirectoryError:  # an archive
        return time_of_change
    except OSError:
        return 0
    return crc32("\0".join(names).encode("utf-8", "surrogateescape"))


def _is_of_package(name: str) -> bool:
    return "." not in name or name.endswith((".py", ".so", ".pyd", "-info"))


def _terminal() -> list[str]:
    """Settings that affect how standard output is written."""
    values = [f"{name}={os.environ.get(name)}" for name in _OF_THE_TERMINAL]
    if sys.stdout is None or not sys.stdout.isatty():
        return values
    try:
        size = os.get_terminal_size(sys.stdout.fileno()).columns
    except (OSError, ValueError):
        size = 0
    return [*values, f"{sys.stdout.encoding} {size}"]


def replay(words: list[str]) -> int | None:
    """Replay an earlier check and return its exit code; None if it is not in the cache."""
    key = cache_key(words)
    if key is None or sys.stdout is None:
        return None
    try:
        with opened(path_of(key)) as file:
            entry = decode(file.read())
    except (OSError, ValueError):
        return None
    if entry.key != key:
        return None
    now = time.time_ns()
    answers = file_log.present_answers(entry.answers, entry.since)
    if answers is None:
        return None
    if answers != entry.answers:
        from urdfkit.cli.result_recording import store

        # Only times of files have changed, such as by git. Saves the next comparison of contents.
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
            from urdfkit.cli.output import handle_write_error

            handle_write_error(error)
    return entry.code

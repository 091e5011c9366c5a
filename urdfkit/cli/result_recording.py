"""Writes the result of a check with its dependencies to the cache, for `result_cache`."""

import time

from urdfkit.cli import result_entry
from urdfkit.cli.result_entry import ResultEntry
from urdfkit.core import cache_entries, disk
from urdfkit.core.file_log import FileLog
from urdfkit.core.own_sources import log_sources

#: Most bytes of all entries.
MAX_BYTES = 64 * 1024 * 1024

#: The key whose result is recorded, and its start in nanoseconds since the epoch.
_begun: tuple[bytes, int] | None = None


def begin(key: bytes) -> None:
    """Start recording the files that this process depends on."""
    global _begun  # noqa: PLW0603 - one process answers one command line
    _begun = (key, time.time_ns())
    disk.log_to(FileLog())


def finish(code: int, outputs: list[tuple[str, bytes]]) -> None:
    """Store the result of the recorded check; no effect without a recording.

    Args:
        code: exit code.
        outputs: files and contents; an empty name is standard output.
    """
    log = disk.log()
    if log is None or _begun is None:
        return
    log_sources()
    disk.log_to(None)
    if log.is_complete:
        answers = [(kind, path, answer) for (kind, path), answer in log.answers.items()]
        store(ResultEntry(*_begun, answers, code, outputs))


def store(entry: ResultEntry) -> None:
    """Write an entry; ignores failures."""
    cache_entries.store(result_entry.path_of(entry.key), result_entry.encode(entry), MAX_BYTES)

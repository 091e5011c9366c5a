"""Writes the result of a check with its dependencies to the cache, for `result_cache`."""

import os
import time

from urdfkit.cli import result_entry
from urdfkit.cli.result_entry import ResultEntry
from urdfkit.core import atomic, disk
from urdfkit.core.file_log import FileLog
from urdfkit.core.own_sources import log_sources
from urdfkit.errors import UnwritableFile

#: Most bytes of all entries; above it, the older half is removed.
MAX_BYTES = 64 * 1024 * 1024

#: Average number of bytes written between two checks of the total size.
BYTES_BETWEEN_LOOKS = 1024 * 1024

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
    path = result_entry.path_of(entry.key)
    directory = os.path.dirname(path)
    try:
        os.makedirs(directory, exist_ok=True)
        data = result_entry.encode(entry)
        # The name is a checksum, which serves as a uniform random number.
        if int(os.path.basename(path), 16) % BYTES_BETWEEN_LOOKS < len(data):
            _make_room(directory)
        atomic.write(path, data, durable=False)
    except (OSError, UnwritableFile):
        return


def _make_room(directory: str) -> None:
    """Remove the older half of the entries of a full directory."""
    with os.scandir(directory) as scanned:
        entries = [(entry.stat().st_mtime, entry.stat().st_size, entry.path) for entry in scanned]
    if sum(size for _, size, _ in entries) < MAX_BYTES:
        return
    for _, _, path in sorted(entries)[: (len(entries) + 1) // 2]:
        os.unlink(path)

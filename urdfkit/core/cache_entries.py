"""Writing of entries of the cache; full directories lose the older ones."""

import os

from urdfkit.core import atomic
from urdfkit.errors import UnwritableFile

#: How often a directory is listed, on average, while it fills.
LOOKS = 64


def store(path: str, data: bytes, most: int) -> None:
    """Write an entry; ignores failures.

    Args:
        path: of the entry, whose name begins with eight digits of a checksum: they serve as a
            random number, which decides whether the directory is listed.
        most: bytes of all entries of the directory; above it, the older half is removed.
    """
    directory, name = os.path.split(path)
    try:
        os.makedirs(directory, exist_ok=True)
        if int(name[:8], 16) % (most // LOOKS) < len(data):
            _make_room(directory, most)
        atomic.write(path, data, durable=False)
    except (OSError, UnwritableFile):
        return


def _make_room(directory: str, most: int) -> None:
    with os.scandir(directory) as scanned:
        entries = [(entry.stat().st_mtime, entry.stat().st_size, entry.path) for entry in scanned]
    if sum(size for _, size, _ in entries) < most:
        return
    for _, _, path in sorted(entries)[: (len(entries) + 1) // 2]:
        os.unlink(path)

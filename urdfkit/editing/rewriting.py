"""New texts for files: shown as a diff, or written."""

from __future__ import annotations

import difflib
import io
from collections.abc import Iterable

from urdfkit.errors import UnwritableFile
from urdfkit.record import Record
from urdfkit.source import Source


class Rewrite(Record):
    """A new text for a file.

    Attributes:
        path: of the file, as a user would type it.
        before, after: its bytes.
    """

    path: str
    before: bytes
    after: bytes

    def diff(self) -> str:
        """What changes, as a unified diff that ``patch -p0`` takes."""
        before, after = (Source(self.path, data).data for data in (self.before, self.after))
        return diff(self.path, before, after)


def diff(path: str, before: bytes, after: bytes) -> str:
    """What changes of a file, as a unified diff that ``patch -p0`` takes.

    Args:
        path: of the file, as a user would type it.
        before: its text, in UTF-8.
        after: likewise.
    """
    return "".join(
        line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n"
        for line in difflib.unified_diff(_lines(before), _lines(after), path, path)
    )


def _lines(text: bytes) -> list[str]:
    """With their ends, and as ``patch`` counts them: nothing but a line feed ends one."""
    return [*io.StringIO(text.decode("utf-8", "replace"), newline="\n")]


def write(rewrites: Iterable[Rewrite]) -> None:
    """Replace files, each whole or not at all, with the permissions that it has.

    Raises:
        UnwritableFile: a file may not be written, or has changed since it was read.
    """
    from urdfkit import atomic  # which a check that only counts fixes does without

    rewrites = tuple(rewrites)
    for one in rewrites:
        now = on_disk(one.path)
        if now is None:
            raise UnwritableFile(f"{one.path}: there is no such file to change")
        if now != one.before:
            raise UnwritableFile(f"{one.path}: it has changed meanwhile; run it again")
    for one in rewrites:
        atomic.write(one.path, one.after)


def on_disk(path: str) -> bytes | None:
    """The bytes of a file; None if it cannot be read."""
    try:
        with open(path, "rb") as file:
            return file.read()
    except (OSError, ValueError):
        return None

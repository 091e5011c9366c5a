"""New texts for files: shown as a diff, or written."""

from __future__ import annotations

import os
from collections.abc import Iterable

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.errors import FileChanged, UnwritableFile
from urdfkit.text.diagnostic import Edit
from urdfkit.text.editing.apply import apply_edits, encoded
from urdfkit.text.source import Source


class Rewrite(Record):
    """A new text for a file."""

    path: str  # of the file, as a user would type it
    #: before and after: its bytes.
    before: bytes
    after: bytes

    def diff(self) -> str:
        """What changes, as a unified diff that ``patch -p0`` takes."""
        from urdfkit.text.editing.diff import diff  # which a check that counts fixes does without

        before, after = (Source(self.path, data).data for data in (self.before, self.after))
        return diff(self.path, before, after)


def rewrites(edits: Iterable[Edit]) -> tuple[Rewrite, ...]:
    """The files of some edits with these made; nothing is written.

    Raises:
        UnwritableFile: a file has changed since it was read.
    """
    by_source: dict[Source, list[Edit]] = {}
    for edit in edits:
        by_source.setdefault(edit.span.source, []).append(edit)
    found = []
    for source, changes in by_source.items():
        before = unchanged(source)
        after = encoded(apply_edits(source.data, changes), source.encoding, before)
        found.append(Rewrite(os.path.normpath(source.path), before, after))
    return tuple(found)


def write(rewrites: Iterable[Rewrite]) -> None:
    """Replace files, each whole or not at all, with the permissions that it has.

    Raises:
        UnwritableFile: a file may not be written, or has changed since it was read.
    """
    from urdfkit.core import atomic  # which a check that only counts fixes does without

    rewrites = tuple(rewrites)
    for one in rewrites:
        now = on_disk(one.path)
        if now is None:
            raise UnwritableFile(f"{one.path}: file not found")
        if now != one.before:
            raise FileChanged(one.path)
    for one in rewrites:
        atomic.write(one.path, one.after, before=one.before)


def unchanged(source: Source) -> bytes:
    """The bytes of the file of a source; none if it is not there.

    Raises:
        UnwritableFile: it has changed since it was read.
    """
    now = on_disk(source.path)
    if now is not None and Source(source.path, now).data != source.data:
        raise FileChanged(source.path)
    return now or b""


def on_disk(path: str) -> bytes | None:
    """The bytes of a file; None if it cannot be read."""
    try:
        return disk.read(path)
    except (OSError, ValueError):
        return None

"""New contents of files: shown as a diff, or written."""

from __future__ import annotations

import os
from collections.abc import Iterable

from urdfkit.core import disk
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.errors import FileChanged, UnwritableFile
from urdfkit.text.diagnostic import Edit
from urdfkit.text.editing.apply import apply_edits, encoded
from urdfkit.text.source import Source

#: Why a file with bytes that are no text is not edited.
NOT_TEXT = "the file is not valid text"


class Rewrite(Record):
    """New contents of a file."""

    path: str  # relative to the current directory, or absolute
    before: bytes
    after: bytes

    def diff(self) -> str:
        """The change as a unified diff for ``patch -p0``."""
        from urdfkit.text.editing.diff import diff  # not needed to count fixes

        before, after = (Source(self.path, data).data for data in (self.before, self.after))
        return diff(self.path, before, after)


def rewrites(edits: Iterable[Edit]) -> tuple[Rewrite, ...]:
    """The files of edits with these applied; nothing is written.

    Raises:
        UnwritableFile: a file has changed since it was read, or is not valid text, of which the
            source has lost bytes.
    """
    results = []
    for source, changes in by_key((edit.span.source, edit) for edit in edits).items():
        if source.undecodable is not None:
            raise UnwritableFile(f"{source.path}: {NOT_TEXT}")
        before = unchanged(source)
        after = encoded(apply_edits(source.data, changes), source.encoding, before)
        results.append(Rewrite(os.path.normpath(source.path), before, after))
    return tuple(results)


def write(rewrites: Iterable[Rewrite]) -> None:
    """Replace files atomically, with their permissions.

    Raises:
        UnwritableFile: a file is not writable, or has changed since it was read.
    """
    from urdfkit.core import atomic  # not needed to count fixes

    rewrites = tuple(rewrites)
    for rewrite in rewrites:
        now = disk.contents(rewrite.path)
        if now is None:
            raise UnwritableFile(f"{rewrite.path}: file not found")
        if now != rewrite.before:
            raise FileChanged(rewrite.path)
    for rewrite in rewrites:
        atomic.write(rewrite.path, rewrite.after, before=rewrite.before)


def unchanged(source: Source) -> bytes:
    """The bytes of the file of a source; empty if it does not exist.

    Raises:
        UnwritableFile: it has changed since it was read.
    """
    now = disk.contents(source.path)
    if now is not None and Source(source.path, now).data != source.data:
        raise FileChanged(source.path)
    return now or b""

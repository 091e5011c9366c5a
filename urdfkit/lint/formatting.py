"""format_files(): descriptions formatted, file by file."""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.errors import UnreadableFile, UrdfkitError
from urdfkit.lint.config import Config
from urdfkit.lint.discovery import descriptions
from urdfkit.text.editing import rewriting
from urdfkit.text.editing.apply import encoded
from urdfkit.text.editing.formatter import WIDTH, formatted
from urdfkit.text.editing.rewriting import Rewrite, on_disk
from urdfkit.text.source import Source, shown
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.ownership import OUTSIDE, READ_ONLY, Ownership
from urdfkit.workspace.resolve import Resolver


class Formatted(Record):
    """The outcome of formatting some files; nothing is written before ``write``.

    Attributes:
        files: that change.
        unchanged: paths of files that are formatted already.
        skipped: paths of files that are left alone, each with the reason.
        failed: paths of files that were named and cannot be formatted, each with the reason.
    """

    files: tuple[Rewrite, ...]
    unchanged: tuple[str, ...]
    skipped: tuple[tuple[str, str], ...]
    failed: tuple[tuple[str, str], ...]

    def diff(self) -> str:
        """All changes as a unified diff."""
        return "".join(file.diff() for file in self.files)

    def write(self) -> None:
        """Replace the files, each whole or not at all.

        Raises:
            UnwritableFile: a file may not be written, or has changed since it was read.
        """
        rewriting.write(self.files)


def format_files(
    *files: str | os.PathLike[str],
    width: int = 0,
    force: bool = False,
    check: bool = False,
    config: Config | None = None,
) -> Formatted:
    """Format URDF and xacro files; what they say stays the same.

    >>> format_files("models/good/gripper.urdf").unchanged
    ('models/good/gripper.urdf',)

    Args:
        files: descriptions, or directories, of which all descriptions are formatted.
        width: columns of a line; as the configuration says, or 100, if it is 0.
        force: format files as well that are generated, read-only or that git ignores.
        check: nothing will be written, so that read-only files count as well.
        config: of the project; it may exclude files.

    Raises:
        UnreadableFile: a file or directory cannot be read, or a directory holds no description.
    """
    changed: list[Rewrite] = []
    unchanged: list[str] = []
    skipped: list[tuple[str, str]] = []
    failed: list[tuple[str, str]] = []
    config = config or Config()
    width = width or config.width or WIDTH
    for path, directory in _files(files, config):
        reason = _why_skipped(path, directory, force=force)
        if reason and not (check and reason == READ_ONLY):
            skipped.append((path, reason))
            continue
        try:
            rewrite = _formatted(Source.read(path), width)
        except UrdfkitError as error:
            (skipped if directory else failed).append((path, str(error)))
            continue
        if rewrite.after == rewrite.before:
            unchanged.append(path)
        else:
            changed.append(rewrite)
    return Formatted(tuple(changed), tuple(unchanged), tuple(skipped), tuple(failed))


def _why_skipped(path: str, directory: str, *, force: bool) -> str:
    """Why a file is not formatted; empty if it may be."""
    ownership = Ownership([os.path.join(directory, "x") if directory else path], Resolver())
    if directory and not ownership.owns(path):  # a link: it is not even read
        return OUTSIDE
    return "" if force else ownership.why_protected(Source.read(path))


def _files(files: tuple[str | os.PathLike[str], ...], config: Config) -> Iterator[tuple[str, str]]:
    """The paths to format, each once, and the directory that they were found in, if any."""
    seen: set[str] = set()
    for given in files:
        file = os.fspath(given)
        is_directory = disk.is_directory(file)
        for path in _below(file, config) if is_directory else (file,):
            real = disk.real(path)
            if real not in seen:
                seen.add(real)
                yield path, file if is_directory else ""


def _below(directory: str, config: Config) -> list[str]:
    below = descriptions(directory, config, Directories())
    found = [path for path in map(shown, below) if _is_robot(path)]
    if not found:
        raise UnreadableFile(f"{directory}: contains no .urdf and no .xacro with a <robot>")
    return found


def _is_robot(path: str) -> bool:
    """True for a file of a directory that is a description, as far as its text shows."""
    return b"<robot" in (on_disk(path) or b"")


def _formatted(source: Source, width: int) -> Rewrite:
    before = rewriting.unchanged(source)
    after = encoded(formatted(source, width), source.encoding, before)
    return Rewrite(source.path, before, after)

"""format_files(): formats descriptions file by file."""

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
from urdfkit.text.editing.rewriting import Rewrite
from urdfkit.text.source import Source, shown
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.ownership import OUTSIDE, READ_ONLY, Ownership
from urdfkit.workspace.resolve import Resolver


class Formatted(Record):
    """The result of formatting files; nothing is written before ``write``.

    Attributes:
        files: changed files.
        unchanged: paths of files that are already formatted.
        skipped: paths of files that are not formatted, each with the reason.
        failed: paths of named files that cannot be formatted, each with the reason.
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
    """Format URDF and xacro files without changing their content.

    >>> format_files("models/good/gripper.urdf").unchanged
    ('models/good/gripper.urdf',)

    Args:
        files: descriptions, or directories, whose descriptions are all formatted.
        width: columns of a line; if 0, the value of the configuration, or else 100.
        force: also format files that are generated, read-only or ignored by git.
        check: also include read-only files, as nothing will be written.
        config: configuration of the project; it may exclude files.

    Raises:
        UnreadableFile: a file or directory cannot be read, or a directory has no description.
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
    if directory and not ownership.owns(path):  # a link to the outside is not read
        return OUTSIDE
    return "" if force else ownership.why_protected(Source.read(path))


def _files(files: tuple[str | os.PathLike[str], ...], config: Config) -> Iterator[tuple[str, str]]:
    """The distinct paths to format, each with the directory that it was found in, if any."""
    known: set[str] = set()
    for file in (os.fspath(path) for path in files):
        is_directory = disk.is_directory(file)
        for path in _below(file, config) if is_directory else (file,):
            real = disk.real(path)
            if real not in known:
                known.add(real)
                yield path, file if is_directory else ""


def _below(directory: str, config: Config) -> list[str]:
    below = descriptions(directory, config, Directories())
    robots = [path for path in map(shown, below) if _is_robot(path)]
    if not robots:
        raise UnreadableFile(f"{directory}: contains no .urdf and no .xacro with a <robot>")
    return robots


def _is_robot(path: str) -> bool:
    """True if a file contains ``<robot``."""
    return b"<robot" in (disk.contents(path) or b"")


def _formatted(source: Source, width: int) -> Rewrite:
    before = rewriting.unchanged(source)
    after = encoded(formatted(source, width), source.encoding, before)
    return Rewrite(source.path, before, after)

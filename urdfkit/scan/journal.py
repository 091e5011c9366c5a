"""Results of a scan on disk: a JSON line for each model, written as soon as it is checked."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any, BinaryIO

from urdfkit import __version__
from urdfkit.core import atomic
from urdfkit.errors import UnreadableFile, UnwritableFile
from urdfkit.scan.rows import ModelRow

#: Files in the results directory.
SETTINGS, RESULTS = "scan.json", "results.jsonl"
#: Keys of each line.
_COLUMNS = frozenset(ModelRow._fields)


class Journal:
    """Writer of the rows of a scan, as a context manager.

    A killed run leaves whole lines and perhaps an incomplete one, which the next run truncates
    before it appends.

    Attributes:
        done: names of the models that have a line.

    Raises:
        UnwritableFile: the file cannot be written, another scan is writing it, or the directory
            contains a scan with other options.
    """

    def __init__(self, directory: str, options: dict[str, Any]) -> None:
        atomic.make_directory(directory)
        _claim(directory, {"urdfkit": __version__, **options})
        path = os.path.join(directory, RESULTS)
        try:
            self._file = open(path, "a+b")  # noqa: SIM115 - closed at exit
        except OSError as error:
            raise UnwritableFile(f"{path}: {error.strerror}") from error
        try:
            _lock(self._file, path)
            self._file.seek(0)
            self.done = {row["model"] for row in _lines(self._file, truncates=True)}
        except BaseException:
            self._file.close()
            raise

    def __enter__(self) -> Journal:  # noqa: PYI034 - Self is not in Python 3.10
        return self

    def __exit__(self, *error: object) -> None:
        self._file.close()

    def write(self, row: ModelRow) -> None:
        """Append the result of a model.

        Raises:
            UnwritableFile: the disk is full.
        """
        content = {**row._asdict(), "findings": [finding._asdict() for finding in row.findings]}
        try:
            self._file.write(json.dumps(content).encode() + b"\n")
            self._file.flush()  # so that the row is on disk if the process is killed
        except OSError as error:
            raise UnwritableFile(f"{self._file.name}: {error.strerror}") from error


def rows(directory: str) -> Iterator[dict[str, Any]]:
    """The models of a scan with their ``findings``, in the order of completion.

    Raises:
        UnreadableFile: the directory does not contain a scan.
    """
    path = os.path.join(directory, RESULTS)
    try:
        with open(path, "rb") as file:
            yield from _lines(file)
    except OSError as error:
        raise UnreadableFile(
            f"{directory}: contains no results of a scan ({error.strerror})"
        ) from error


def _lines(file: BinaryIO, *, truncates: bool = False) -> Iterator[dict[str, Any]]:
    """The whole lines of a file; an incomplete last one is truncated if requested."""
    end = 0
    for line in file:
        if not line.endswith(b"\n"):
            break  # a scan is writing it, or was killed
        end += len(line)
        yield _row(line, file.name)
    if truncates:
        file.truncate(end)


def _row(line: bytes, path: str) -> dict[str, Any]:
    """A model as written by `Journal.write`."""
    try:
        row = json.loads(line)
    except (ValueError, RecursionError):
        row = None
    if not isinstance(row, dict) or not row.keys() >= _COLUMNS:
        raise UnreadableFile(f"{path}: contains no results of a scan by this version of urdfkit")
    return row


def _claim(directory: str, options: dict[str, Any]) -> None:
    """Write the options of a scan; a resumed scan must have the same options."""
    path = os.path.join(directory, SETTINGS)
    text = json.dumps(options, indent=1, sort_keys=True) + "\n"
    try:
        with open(path, encoding="utf-8") as file:
            existing = file.read()
    except FileNotFoundError:
        atomic.write(path, text.encode())
        return
    except (OSError, UnicodeDecodeError) as error:
        raise UnwritableFile(f"{path}: {error}") from error
    if existing != text:
        raise UnwritableFile(
            f"{directory}: contains a scan with other options or by another version (see {path}); "
            "remove it, or pass another directory"
        )


def _lock(file: BinaryIO, path: str) -> None:
    """Lock a file against other scans until it is closed or the process ends."""
    try:
        import fcntl
    except ImportError:  # Windows
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        raise UnwritableFile(f"{path}: another scan is writing it") from error

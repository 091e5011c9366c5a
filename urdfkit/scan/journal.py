"""The results of a scan on disk: a line of JSON for every model, as soon as it is done."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any, BinaryIO

from urdfkit import __version__
from urdfkit.core import atomic
from urdfkit.errors import UnreadableFile, UnwritableFile
from urdfkit.scan.rows import ModelRow

#: Names of files in the directory of results.
SETTINGS, RESULTS = "scan.json", "results.jsonl"
#: What each model has.
_COLUMNS = frozenset(ModelRow._fields)


class Journal:
    """Where the rows of a scan go; use it in a ``with`` statement.

    A run that is killed leaves whole lines, and perhaps the beginning of one more, which is cut
    off: the next run goes on behind them.

    Attributes:
        done: the names of the models that have a line.

    Raises:
        UnwritableFile: it cannot be written, another scan is writing it, or it holds a scan with
            other options.
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
            self.done = {row["model"] for row in _whole_lines(self._file)}
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
        content = {**row._asdict(), "findings": [found._asdict() for found in row.findings]}
        try:
            self._file.write(json.dumps(content).encode() + b"\n")
            self._file.flush()  # so that the row is on disk if the process is killed
        except OSError as error:
            raise UnwritableFile(f"{self._file.name}: {error.strerror}") from error


def rows(directory: str) -> Iterator[dict[str, Any]]:
    """The models of a scan, each with its ``findings``, in the order in which they were done.

    Raises:
        UnreadableFile: the directory holds no scan.
    """
    path = os.path.join(directory, RESULTS)
    try:
        with open(path, "rb") as file:
            yield from _lines(file)
    except OSError as error:
        raise UnreadableFile(
            f"{directory}: holds no results of a scan ({error.strerror})"
        ) from error


def _lines(file: BinaryIO) -> Iterator[dict[str, Any]]:
    for line in file:
        if not line.endswith(b"\n"):
            return  # a scan is writing it, or was killed
        yield _row(line, file.name)


def _whole_lines(file: BinaryIO) -> Iterator[dict[str, Any]]:
    """The lines of a file, which is then without the beginning of another one."""
    file.seek(0)
    end = 0
    for line in file:
        if not line.endswith(b"\n"):
            break
        end += len(line)
        yield _row(line, file.name)
    file.truncate(end)


def _row(line: bytes, path: str) -> dict[str, Any]:
    """A model as `Journal.write` has written it."""
    try:
        row = json.loads(line)
    except (ValueError, RecursionError):
        row = None
    if not isinstance(row, dict) or not row.keys() >= _COLUMNS:
        raise UnreadableFile(f"{path}: holds no results of a scan by this version of urdfkit")
    return row


def _claim(directory: str, options: dict[str, Any]) -> None:
    """Note the options of a scan; those of one that goes on must be the same."""
    path = os.path.join(directory, SETTINGS)
    text = json.dumps(options, indent=1, sort_keys=True) + "\n"
    try:
        with open(path, encoding="utf-8") as file:
            known = file.read()
    except FileNotFoundError:
        atomic.write(path, text.encode())
        return
    except (OSError, UnicodeDecodeError) as error:
        raise UnwritableFile(f"{path}: {error}") from error
    if known != text:
        raise UnwritableFile(
            f"{directory}: holds a scan with other options or by another version (see {path}); "
            "remove it, or pass another directory"
        )


def _lock(file: BinaryIO, path: str) -> None:
    """Keep other scans from a file until it is closed; the system does so, also after a kill."""
    try:
        import fcntl
    except ImportError:  # Windows
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError as error:
        raise UnwritableFile(f"{path}: another scan is writing it") from error

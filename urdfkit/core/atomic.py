"""Writing files so that no reader ever sees half of one."""

from __future__ import annotations

import os
import stat
from collections.abc import Iterable

from urdfkit.core import limits
from urdfkit.errors import UnwritableFile


def write(
    path: str | os.PathLike[str], data: bytes | Iterable[bytes], *, durable: bool = True
) -> None:
    """Write a file whole or not at all; one that exists keeps its permissions.

    The bytes go to a new file in the same directory, which then takes the name. A link stays one.
    What is no regular file, such as ``/dev/stderr``, is written to directly.

    Args:
        path: of the file.
        data: all that it is to hold, or its parts.
        durable: wait until the disk has it; a cache does without.

    Raises:
        UnwritableFile: the directory is missing, or permission or space.
    """
    if durable:
        limits.end_time()
    try:
        parts = (data,) if isinstance(data, bytes) else data
        _write(os.path.realpath(path), parts, durable=durable)
    except OSError as error:
        raise UnwritableFile(f"{os.fspath(path)}: {_why_unwritable(path, error)}") from error
    except ValueError as error:  # a NUL in the name
        raise UnwritableFile(f"{os.fspath(path)!r}: {error}") from error


def make_directory(path: str | os.PathLike[str]) -> None:
    """Make a directory and those above it, where they are missing.

    Raises:
        UnwritableFile: a file is in the way, or permission is missing.
    """
    try:
        os.makedirs(path, exist_ok=True)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise UnwritableFile(
            f"{os.fspath(path)}: cannot create this directory: {reason}"
        ) from error


def _write(path: str, parts: Iterable[bytes], *, durable: bool) -> None:
    try:
        mode = os.stat(path).st_mode
    except FileNotFoundError:
        mode = None
    if mode is not None and not stat.S_ISREG(mode):
        with open(path, "wb") as file:
            file.writelines(parts)
        return
    temporary = f"{path}.{os.getpid()}.tmp"
    file = open(temporary, "xb")  # noqa: SIM115 - closed before it takes the name
    try:
        with file:
            file.writelines(parts)
            file.flush()
            if durable:
                os.fsync(file.fileno())
        if mode is not None:
            os.chmod(temporary, stat.S_IMODE(mode))
        os.replace(temporary, path)
    except BaseException:
        os.unlink(temporary)
        raise


def _why_unwritable(path: str | os.PathLike[str], error: OSError) -> str:
    """The reason, and how to fix it."""
    directory = os.path.dirname(path) or "."
    if os.path.isdir(path):
        return "is a directory; pass a file in it"
    if not os.path.isdir(directory):
        return f"no such directory '{directory}'; create it first"
    return f"cannot be written: {error.strerror or error}"

"""The archives of a scan: their members, and their extraction within limits."""

from __future__ import annotations

import os
import shutil
import tarfile
import tempfile
import zipfile
import zlib
from collections.abc import Callable, Iterator
from errno import ENOSPC
from functools import partial
from typing import IO

from urdfkit.errors import UnreadableFile, UnwritableFile

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing_extensions import Self

try:
    from lzma import LZMAError
except ImportError:  # Python without lzma

    class LZMAError(Exception):  # type: ignore[no-redef]
        pass


_TARS = (".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tar.xz")
#: Suffixes of archives.
SUFFIXES = (".zip", *_TARS)
#: Limit of the extracted bytes of a small archive, and of the compression ratio of others.
_LARGE, _MAX_RATIO = 2 * 10**9, 100
#: Files and directories that any archive may have, and least bytes of larger archives for each.
_MAX_MEMBERS, _BYTES_PER_MEMBER = 20_000, 128
#: Headers of the next member of a tar, such as a long name, and their largest size in bytes.
_HEADERS = (
    tarfile.GNUTYPE_LONGNAME, tarfile.GNUTYPE_LONGLINK, tarfile.XHDTYPE, tarfile.XGLTYPE,
    tarfile.SOLARIS_XHDTYPE,
)  # fmt: skip
_MAX_HEADER = 2**20


class _HugeHeader(Exception):
    """A header is larger than any valid one."""


#: Errors of damaged or encrypted archives.
_UNREADABLE = (
    OSError, EOFError, RuntimeError, ValueError, IndexError, MemoryError,
    tarfile.TarError, zipfile.BadZipFile, zlib.error, LZMAError, _HugeHeader,
)  # fmt: skip


def members(
    archive: str, is_wanted: Callable[[str, Callable[[int], bytes]], bool]
) -> Iterator[str]:
    """The names of files in an archive, sorted.

    Args:
        is_wanted: called with the name of each file, and a function that reads its first bytes.

    Raises:
        UnreadableFile: the archive is damaged, or too large when extracted.
    """
    is_tar = archive.lower().endswith(_TARS)
    try:
        names = [
            name
            for name, open_member in (_tar_members if is_tar else _zip_members)(archive)
            if is_wanted(name, partial(_head, open_member))
        ]
    except _UNREADABLE as error:
        raise UnreadableFile(f"{archive}: not a readable archive ({_why(error)})") from error
    plain = map(os.path.normpath, names)
    # Paths outside of the archive are not extracted; a file with such a path is another file.
    yield from sorted(
        name for name in plain if not os.path.isabs(name) and name.split(os.sep)[0] != os.pardir
    )


class _TarMember(tarfile.TarInfo):
    """A member with small headers: tarfile reads headers of any size into memory."""

    @classmethod
    def frombuf(cls, buf: bytes | bytearray, encoding: str | None, errors: str) -> Self:
        member = super().frombuf(buf, encoding, errors)  # type: ignore[arg-type]  # of typeshed
        if member.type in _HEADERS and member.size > _MAX_HEADER:
            raise _HugeHeader(f"it has a header of {member.size:,} bytes")
        return member


def _tar_members(archive: str) -> Iterator[tuple[str, Callable[[], IO[bytes] | None]]]:
    """The files in an archive, each with a function that opens it before the next is requested."""
    size = 0
    count = _MemberCount(archive)
    with tarfile.open(archive, tarinfo=_TarMember) as tar:
        for member in tar:
            size += member.size
            count.add(member.name)
            # Before it is unpacked to find the next one.
            _check_ratio(archive, max(size, member.offset_data))
            if member.isfile():
                yield member.name, partial(tar.extractfile, member)


def _zip_members(archive: str) -> Iterator[tuple[str, Callable[[], IO[bytes] | None]]]:
    """Like `_tar_members`, for a ZIP archive."""
    with zipfile.ZipFile(archive) as packed:
        _check_ratio(archive, sum(member.file_size for member in packed.infolist()))
        count = _MemberCount(archive)
        for member in packed.infolist():
            count.add(member.filename)
        for member in packed.infolist():
            if not member.is_dir():
                yield member.filename, partial(packed.open, member)


def _head(open_member: Callable[[], IO[bytes] | None], most: int) -> bytes:
    """The first bytes of a member of an archive."""
    file = open_member()
    if file is None:
        return b""
    with file:
        return file.read(most)


def extract(archive: str, directory: str) -> None:
    """Extract an archive; neither library writes outside of the directory.

    Raises:
        UnreadableFile: the archive is damaged.
        UnwritableFile: the archive is too large for the disk.
    """
    free = shutil.disk_usage(directory).free
    try:
        if archive.lower().endswith(_TARS):
            with tarfile.open(archive, tarinfo=_TarMember) as tar:
                _check_room(archive, sum(member.size for member in tar), free)
                tar.extractall(directory, filter=_inside)
        else:
            with zipfile.ZipFile(archive) as packed:
                _check_room(archive, sum(member.file_size for member in packed.infolist()), free)
                packed.extractall(directory)
    except _UNREADABLE as error:
        message = f"{archive}: cannot be extracted ({_why(error)})"
        is_full = isinstance(error, OSError) and error.errno == ENOSPC
        raise (UnwritableFile if is_full else UnreadableFile)(message) from error


def _inside(member: tarfile.TarInfo, directory: str) -> tarfile.TarInfo | None:
    """The member; None for one that leads out of the directory, such as a link to /opt/ros."""
    try:
        return tarfile.data_filter(member, directory)
    except tarfile.FilterError:
        return None


def _why(error: Exception) -> str:
    return "too little memory for it" if isinstance(error, MemoryError) else str(error)


def _check_ratio(archive: str, size: int) -> None:
    """Reject archives that would fill the disk."""
    ratio = size / max(os.path.getsize(archive), 1)
    if size > _LARGE and ratio > _MAX_RATIO:
        raise UnreadableFile(
            f"{archive}: more than {_LARGE / 1e9:.1f} GB when extracted, over {_MAX_RATIO} times "
            "its size; extract it yourself if you trust it, and pass the directory"
        )


class _MemberCount:
    """Counts files and directories, and rejects archives with millions of empty ones."""

    def __init__(self, archive: str) -> None:
        self._archive = archive
        self._most = self._left = max(_MAX_MEMBERS, os.path.getsize(archive) // _BYTES_PER_MEMBER)
        self._directories = {""}

    def add(self, name: str) -> None:
        """Count a member and its directories.

        Raises:
            UnreadableFile: there are too many.
        """
        self._left -= 1
        while self._left >= 0 and (name := name.rpartition("/")[0]) not in self._directories:
            self._directories.add(name)
            self._left -= 1
        if self._left < 0:
            raise UnreadableFile(
                f"{self._archive}: more than {self._most:,} files and directories; extract it "
                "yourself if you trust it, and pass the directory"
            )


def _check_room(archive: str, needed: int, free: int) -> None:
    if needed > free:
        raise UnwritableFile(
            f"{archive}: {needed / 1e9:.1f} GB when extracted; {free / 1e9:.1f} GB are free "
            f"in {tempfile.gettempdir()} (set TMPDIR to another directory)"
        )

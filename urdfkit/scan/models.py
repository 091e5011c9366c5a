"""The models of the sources of a scan, one after another."""

from __future__ import annotations

import glob
import os
import re
import shutil
import tarfile
import tempfile
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from errno import ENOSPC
from functools import partial
from typing import IO

from urdfkit.core.record import Record
from urdfkit.core.regular_file import opened
from urdfkit.core.temporary import remove_abandoned, scratch
from urdfkit.errors import UnreadableFile, UnwritableFile
from urdfkit.text.source import why_unreadable
from urdfkit.workspace.directories import walk
from urdfkit.workspace.file_head import read_head

TYPE_CHECKING = False

if TYPE_CHECKING:
    from typing_extensions import Self

try:
    from lzma import LZMAError
except ImportError:  # Python without lzma

    class LZMAError(Exception):  # type: ignore[no-redef]
        pass


#: Suffixes of the models in a directory or an archive.
SUFFIXES = (".urdf", ".urdf.xacro")
#: Other xacro files are robots if the root has a name, which libraries do not need.
_NAMED_ROOT, _HEAD = re.compile(rb"<robot\b[^>]*\bname\s*="), 8192
_LISTS = (".txt", ".lst")
_MAX_LINE = 65_536
_TARS = (".tar", ".tar.gz", ".tgz", ".tar.bz2", ".tar.xz")
_ARCHIVES = (".zip", *_TARS)
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


class Model(Record):
    """A description in a collection."""

    #: Name in the results: the path as in the source; for a member of an archive, the path of the
    #: archive joined with the path in it.
    name: str
    path: str  # on disk
    archive: str = ""  # the archive that contains it; empty if none
    directory: str = ""  # to which the archive was extracted
    #: Why the model cannot be checked, such as a damaged archive; empty otherwise.
    problem: str = ""


def models(sources: Iterable[str], lists: frozenset[str] = frozenset()) -> Iterator[Model]:
    """The models of sources; models in archives have no path yet.

    An unreadable source is a model with a problem: the scan continues with the others.

    Args:
        sources: descriptions, directories, archives, globs, and files that list these.
        lists: real paths of the lists that contain the sources.
    """
    for source in sources:
        try:
            yield from _models_of(source, lists)
        except UnreadableFile as error:
            yield Model(source, "", problem=str(error))


def require_sources(sources: Iterable[str]) -> None:
    """Check that sources exist, before the first model is checked.

    Raises:
        UnreadableFile: a source does not exist, or is a glob that matches nothing.
    """
    for source in sources:
        if not _is_glob(source):
            if not os.path.isdir(source):
                _require_readable(source)
        elif next(glob.iglob(source, recursive=True), None) is None:
            raise UnreadableFile(f"no file matches '{source}'")


def _models_of(source: str, lists: frozenset[str]) -> Iterator[Model]:
    name = source.lower()
    if os.path.isdir(source):
        paths = (path for path in walk(source) if _is_robot(path, partial(read_head, path, _HEAD)))
        yield from (Model(path, path) for path in paths)
    elif os.path.isfile(source) and name.endswith(_ARCHIVES):
        yield from (Model(f"{source}/{member}", "", source) for member in _members(source))
    elif os.path.isfile(source) and name.endswith(_LISTS):
        real = os.path.realpath(source)
        if real in lists:
            raise UnreadableFile(f"{source}: this list contains itself")
        yield from models(_listed(source), lists | {real})
    elif _is_glob(source):
        require_sources([source])
        yield from models(glob.iglob(source, recursive=True), lists)
    else:
        _require_readable(source)
        yield Model(source, source)


def _is_glob(source: str) -> bool:
    return glob.has_magic(source) and not os.path.lexists(source)


class _TarMember(tarfile.TarInfo):
    """A member with small headers: tarfile reads headers of any size into memory."""

    @classmethod
    def frombuf(cls, buf: bytes | bytearray, encoding: str | None, errors: str) -> Self:
        member = super().frombuf(buf, encoding, errors)  # type: ignore[arg-type]  # of typeshed
        if member.type in _HEADERS and member.size > _MAX_HEADER:
            raise _HugeHeader(f"it has a header of {member.size:,} bytes")
        return member


class Extraction:
    """The archives of a scan, extracted on demand; a context manager.

    The extracted files are removed at exit.
    """

    def __init__(self) -> None:
        self._directories: dict[str, str] = {}
        self._problems: dict[str, str] = {}
        self._until_exit = ExitStack()

    def __enter__(self) -> Extraction:  # noqa: PYI034 - Self is not in Python 3.10
        remove_abandoned()  # of killed scans
        return self

    def __exit__(self, *error: object) -> None:
        self._until_exit.close()

    def on_disk(self, model: Model) -> Model:
        """The model with its path on disk, or with the problem of its archive.

        Raises:
            UnwritableFile: the archive is too large for the disk.
        """
        if not model.archive:
            return model
        if model.archive not in self._directories:
            directory = self._until_exit.enter_context(scratch())
            self._directories[model.archive] = directory
            try:
                _extract(model.archive, directory)
            except UnreadableFile as error:
                self._problems[model.archive] = str(error)
        if problem := self._problems.get(model.archive):
            return model._replace(problem=problem)
        directory = self._directories[model.archive]
        path = os.path.join(directory, model.name[len(model.archive) + 1 :])
        return model._replace(path=path, directory=directory)


def _require_readable(path: str) -> None:
    try:
        opened(path).close()
    except OSError as error:
        raise UnreadableFile(f"{path}: {why_unreadable(path, error)}") from error


def _is_robot(path: str, head: Callable[[], bytes]) -> bool:
    """True for a file that is a model by its suffix or, for another xacro, by its head."""
    name = path.lower()  # SolidWorks writes .URDF
    if name.endswith(SUFFIXES):
        return True
    return name.endswith(".xacro") and _NAMED_ROOT.search(head()) is not None


def _listed(path: str) -> Iterator[str]:
    """The lines of a list; paths are relative to the directory of the list."""
    directory = os.path.dirname(path)
    try:
        with opened(path) as file:
            while data := file.readline(_MAX_LINE):
                line = data.decode("utf-8").strip()
                if "\0" in line:
                    raise ValueError("it contains a NUL")
                if line and not line.startswith("#"):
                    yield os.path.join(directory, line)
    except (OSError, ValueError) as error:
        raise UnreadableFile(f"{path}: not a list of files ({_why(error)})") from error


def _members(archive: str) -> Iterator[str]:
    """The names of the models in an archive, sorted."""
    is_tar = archive.lower().endswith(_TARS)
    try:
        names = [
            name
            for name, open_member in (_tar_members if is_tar else _zip_members)(archive)
            if _is_robot(name, partial(_head, open_member))
        ]
    except _UNREADABLE as error:
        raise UnreadableFile(f"{archive}: not a readable archive ({_why(error)})") from error
    plain = map(os.path.normpath, names)
    # Paths outside of the archive are not extracted; a file with such a path is another file.
    yield from sorted(
        name for name in plain if not os.path.isabs(name) and name.split(os.sep)[0] != os.pardir
    )


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


def _head(open_member: Callable[[], IO[bytes] | None]) -> bytes:
    """The first bytes of a member of an archive."""
    file = open_member()
    if file is None:
        return b""
    with file:
        return file.read(_HEAD)


def _extract(archive: str, directory: str) -> None:
    """Extract an archive; neither library writes outside of the directory."""
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

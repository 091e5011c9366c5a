"""The models of the sources of a scan, one after another."""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack
from functools import partial

from urdfkit.core.record import Record
from urdfkit.core.regular_file import opened
from urdfkit.core.temporary import remove_abandoned, scratch
from urdfkit.errors import UnreadableFile
from urdfkit.scan import archives
from urdfkit.text.source import why_unreadable
from urdfkit.workspace.directories import walk
from urdfkit.workspace.file_head import read_head

#: Suffixes of the models in a directory or an archive.
SUFFIXES = (".urdf", ".urdf.xacro")
#: Other xacro files are robots if the root has a name, which libraries do not need.
_NAMED_ROOT, _HEAD = re.compile(rb"<robot\b[^>]*\bname\s*="), 8192
_LISTS = (".txt", ".lst")
_MAX_LINE = 65_536


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
        paths = (path for path in walk(source) if _is_robot(path, partial(read_head, path)))
        yield from (Model(path, path) for path in paths)
    elif os.path.isfile(source) and name.endswith(archives.SUFFIXES):
        members = archives.members(source, _is_robot)
        yield from (Model(f"{source}/{member}", "", source) for member in members)
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
                archives.extract(model.archive, directory)
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


def _is_robot(path: str, head: Callable[[int], bytes]) -> bool:
    """True for a file that is a model by its suffix or, for another xacro, by its head."""
    name = path.lower()  # SolidWorks writes .URDF
    if name.endswith(SUFFIXES):
        return True
    return name.endswith(".xacro") and _NAMED_ROOT.search(head(_HEAD)) is not None


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
        raise UnreadableFile(f"{path}: not a list of files ({error})") from error

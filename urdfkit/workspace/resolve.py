"""Resolution of a robot's file references: package://, model://, file://, relative paths.

A missing package is not a missing file: the package may exist on another machine.
"""

from __future__ import annotations

import os
import re
from _weakref import ref  # ``weakref`` takes 0.7 ms to import
from collections.abc import Callable, Mapping
from itertools import product
from stat import S_ISDIR, S_ISREG

from urdfkit.core import disk
from urdfkit.core.memo import Memo
from urdfkit.core.paths import is_within, upwards
from urdfkit.core.static_typing import Any
from urdfkit.errors import PackageNotFound, UnreadableFile
from urdfkit.text.source import Source
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.package_files import PackageFiles, join
from urdfkit.workspace.packages import Packages, path_list
from urdfkit.workspace.references import DRIVE, ResolvedReference, spellings, split_scheme

#: Why a file is not read; follows its path in a message.
OUTSIDE = "is outside the workspace and the packages of this model"

_MODEL_PATHS = ("GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH")


class Resolver:
    """Finds packages and files; results are cached.

    Args:
        packages: directories of ROS packages by name, which override every search.
        environment: by default that of the process.
        texts: contents of files that differ from the disk, by path: unwritten fixes, or the
            buffers of an editor.

    Raises:
        UnreadableFile: the directory of a package is missing.
    """

    def __init__(
        self,
        packages: Mapping[str, str] | None = None,
        environment: Mapping[str, str] | None = None,
        texts: Mapping[str, bytes] | None = None,
    ) -> None:
        for name, directory in (packages or {}).items():
            if not disk.is_directory(directory):
                raise UnreadableFile(f"package '{name}': no such directory '{directory}'")
        environment = disk.Environment() if environment is None else environment
        self.directories = Directories()
        self.packages = Packages(packages or {}, environment, self.directories)
        self._package_files = PackageFiles(self.packages, self.directories)
        self._model_paths = {name: path_list(environment, name) for name in _MODEL_PATHS}
        self._located: Memo[tuple[str, str, str], ResolvedReference] = Memo()
        self._texts = _by_real_path(texts or {})
        #: Sources in use; the texts of thousands of robots are not cached.
        self._sources: Memo[tuple[object, ...], ref[Source]] = Memo()
        #: Expansions by source and arguments, if the same texts are read repeatedly.
        self.expansions: dict[object, Any] | None = None
        #: Files that the user named, one for each workspace.
        self.admitted: dict[str, str] = {}
        self._admits_everything = False
        self._admitted_roots: set[str] = set()
        self._admitted_levels: set[str] = set()
        self._without_levels: list[str] = []  # files whose levels are not computed yet

    def with_texts(self, texts: Mapping[str, bytes]) -> Resolver:
        """A resolver for other texts, which shares the cached packages and directories."""
        other = Resolver.__new__(Resolver)
        vars(other).update(vars(self))
        other._texts = _by_real_path(texts)
        return other

    def text(self, path: str) -> bytes | None:
        """The contents that replace a file on disk; None if it is not replaced."""
        return self._texts.get(disk.real(path)) if self._texts else None

    def admit(self, path: str, *, trust: bool = False) -> None:
        """Allow models to read the workspace of a file that the user names.

        Before the first call, every file is admitted.

        Args:
            trust: True to allow everything.
        """
        self._admits_everything = self._admits_everything or trust
        workspace = self.packages.workspace(path)
        if workspace not in self.admitted:
            self.admitted[workspace] = path
            self._admitted_roots |= self._roots(path)
            self._without_levels.append(path)

    def admits(self, path: str) -> bool:
        """True if a model may read a file, according to the files that the user named so far."""
        if self._admits_everything or not self.admitted:
            return True
        return self._is_reachable(path, self._admitted_roots, self._levels_of_admitted)

    def _levels_of_admitted(self) -> set[str]:
        while self._without_levels:
            self._admitted_levels |= self._levels(self._without_levels.pop())
        return self._admitted_levels

    def admit_and_read(self, path: str) -> Source:
        """Read a text file that the user names, and allow models to read its workspace.

        Raises:
            UnreadableFile: it is missing, a directory, too large, or not readable.
        """
        self.admit(path)
        return self._read(path)

    def read(self, path: str) -> Source:
        """Read a text file that another file refers to.

        Raises:
            UnreadableFile: it is missing, a directory, too large, not readable, or outside.
        """
        if not self.admits(path):
            raise UnreadableFile(f"{path}: {OUTSIDE}")
        return self._read(path)

    def readable(self, path: str) -> Source | None:
        """Like `read`; None if the file cannot be read."""
        try:
            return self.read(path)
        except UnreadableFile:
            return None

    def _read(self, path: str) -> Source:
        data = self.text(path)
        try:
            key = (path, *disk.version(path)) if data is None else (path, data)
        except (OSError, ValueError):
            return Source.read(path)  # raises the reason
        known = self._sources.get(key)
        source = known() if known else None
        if source is None:
            source = Source.read(path) if data is None else Source(path, data)
            self._sources[key] = ref(source)
        return source

    def package(self, name: str, near: str) -> str:
        """The directory of a ROS package.

        Args:
            near: path of the file that contains the reference.

        Raises:
            PackageNotFound: with the searched locations.
        """
        candidate = self._package_files.choose(name, near, None)
        if candidate is None:
            raise PackageNotFound(name, self.packages.searched(name, near))
        return candidate.directory

    def locate(self, reference: str, near: str, top: str | None = None) -> ResolvedReference:
        """The file that a mesh or texture reference resolves to.

        Args:
            reference: the value of the ``filename`` attribute.
            near: path of the file that contains the reference.
            top: path of the checked file, if different; relative paths are tried from there first.
        """
        top = top or near
        key = (reference, self.packages.directory_of(near), self.packages.directory_of(top))
        if key not in self._located:
            resolved = self._locate(reference, near, top)
            if resolved.path is not None and not self.admits(resolved.path):
                resolved = resolved._replace(path=None, outside=resolved.path)
            self._located[key] = resolved
        return self._located[key]

    def installed(self, path: str) -> str | None:
        """The source file that a build would install at a path of a package; None if unknown.

        ``$(find pkg)/urdf/x`` resolves to a path that does not exist in a source tree if the build
        installs its files in another layout.
        """
        package = self.packages.enclosing(path)
        if package is None:
            return None
        name, directory = package
        relative = os.path.relpath(os.path.abspath(path), directory).replace(os.sep, "/")
        return next(self._package_files.as_installed(name, directory, relative), None)

    def allows(self, path: str, near: str) -> bool:
        """True if a model may read a file: it is in the model's workspace or in a package.

        Symbolic links are resolved, except in packages of the user's environment, which ``colcon
        build --symlink-install`` fills with links. Devices and pipes are rejected, since reading
        them may never end.

        Args:
            path: the file, which need not exist.
        """
        return self._is_reachable(path, self._roots(near), lambda: self._levels(near))

    def _roots(self, near: str) -> set[str]:
        """The real directories of the workspaces of a file and of its link target."""
        near = os.path.abspath(near)
        real = self.directories.real
        return {real(self.packages.workspace(at)) for at in (near, real(near))}

    def _levels(self, near: str) -> set[str]:
        """The real directories that are scanned for the packages that a file refers to."""
        levels = self.packages.levels(os.path.abspath(near))
        return {self.directories.real(level.root) for level in levels}

    def _is_reachable(self, path: str, roots: set[str], levels: Callable[[], set[str]]) -> bool:
        """True if a file is in a workspace or in a package that is scanned or chosen.

        Args:
            path: the file.
            roots: real directories of workspaces, possibly thousands.
            levels: returns the real directories that are scanned for packages.
        """
        path = os.path.abspath(path)
        if "\0" in path:
            return False
        try:
            mode = disk.state(path).st_mode
            if not S_ISREG(mode) and not S_ISDIR(mode):
                return False
        except OSError:
            pass  # a missing file is judged by its path
        real = self.directories.real(path)
        chosen = self._package_files.chosen
        if not roots.isdisjoint(upwards(real)):
            return True
        certain = (self.directories.real(item.directory) for item in chosen if item.certain)
        if any(is_within(real, directory) for directory in certain):
            return True
        if any(is_within(path, candidate.directory) for candidate in chosen if candidate.trusted):
            return True
        package = self.packages.enclosing(real)
        enclosing = [package[1]] if package else []
        enclosing += [
            candidate.directory for candidate in chosen if is_within(real, candidate.directory)
        ]
        return any(not levels().isdisjoint(upwards(directory)) for directory in enclosing)

    def _locate(self, reference: str, near: str, top: str) -> ResolvedReference:
        text = reference.replace("\\", "/")
        scheme, rest = split_scheme(text)
        if scheme in ("package", "model"):
            name, slash, relative = rest.partition("/")
            if scheme == "model":
                return self._in_models(reference, name, rest, near)
            if not slash and os.path.splitext(name)[1]:
                name, relative = "", name  # no package, as in files of onshape-to-robot
            return self._in_package(reference, scheme, name, relative, near)
        if scheme == "file" or text.startswith("file:/"):
            rest = rest if scheme else text[len("file:") :]
            rest = rest.removeprefix("localhost")
        elif scheme:
            return ResolvedReference(reference, scheme)
        if rest.startswith("/") or re.match(DRIVE, rest):
            return self._absolute(reference, rest)
        return self._relative(reference, rest, near, top)

    def _in_package(
        self, reference: str, scheme: str, name: str, relative: str, near: str
    ) -> ResolvedReference:
        candidate = self._package_files.choose(name, near, relative) if name else None
        if candidate is None:
            searched = self.packages.searched(name, near) if name else ()
            return ResolvedReference(reference, scheme, name, None, relative, searched=searched)
        tried: list[str] = []
        path = self._package_files.find(name, candidate.directory, relative, tried)
        return ResolvedReference(
            reference,
            scheme,
            name,
            candidate.directory,
            relative,
            path or self._in_parents(name, relative, near),
            tuple(tried),
        )

    def _in_parents(self, name: str, relative: str, near: str) -> str | None:
        """The file of a package in a parent directory of a file of the package, or of no package.

        A build may copy several directories of a repository into one package.
        """
        package = self.packages.enclosing(near)
        if not relative or (package and package[0] != name):
            return None
        root, directory = self.packages.workspace(near), self.packages.directory_of(near)
        while is_within(directory, root):
            for path in (relative, f"{name}/{relative}"):
                if found := self.directories.find(directory, path):
                    return found
            if directory == root:
                break
            directory = os.path.dirname(directory)
        return None

    def _in_models(self, reference: str, name: str, rest: str, near: str) -> ResolvedReference:
        """The file below Gazebo's model path, which packages may extend."""
        tried: list[str] = []
        places = [(directory, rest) for paths in self._model_paths.values() for directory in paths]
        exported = self.packages.gazebo_model_paths(near)
        places += [(directory, f"{path}/{rest}".lstrip("/")) for directory, path in exported]
        for directory, relative in places:
            tried.append(join(directory, relative))
            path = self.directories.find(directory, relative)
            if path:
                return ResolvedReference(
                    reference, "model", name, directory, rest, path, tuple(tried)
                )
        located = self._in_package(reference, "model", name, rest.partition("/")[2], near)
        searched: tuple[str, ...] = ()
        if located.directory is None:
            searched = tuple(
                f"{variable} ({os.pathsep.join(paths) or 'not set'})"
                for variable, paths in self._model_paths.items()
            )
        return located._replace(
            tried=(*tried, *located.tried), searched=(*searched, *located.searched)
        )

    def _absolute(self, reference: str, text: str) -> ResolvedReference:
        tried: list[str] = []
        file = None
        for spelling in spellings(text):
            path = os.path.normpath(spelling.lstrip("/") if re.match(DRIVE, spelling) else spelling)
            tried.append(path)
            if file := self.directories.find(*os.path.split(path)) or self.installed(path):
                break
        return ResolvedReference(reference, "absolute", None, None, text, file, tuple(tried))

    def _relative(self, reference: str, text: str, near: str, top: str) -> ResolvedReference:
        tried: list[str] = []
        starts = dict.fromkeys(map(self.packages.directory_of, (top, near)))
        path = None
        for directory, relative in product(starts, spellings(text)):
            tried.append(join(directory, relative))
            if path := self.directories.find(directory, relative):
                break
        return ResolvedReference(reference, "relative", None, None, text, path, tuple(tried))


def _by_real_path(texts: Mapping[str, bytes]) -> dict[str, bytes]:
    return {disk.real(path): data for path, data in texts.items()}

"""The mesh files that references to missing files probably mean."""

from __future__ import annotations

import os
import re
from functools import cache, cached_property

from urdfkit.core import disk
from urdfkit.core.grouping import by_key
from urdfkit.core.paths import is_within
from urdfkit.core.record import Record
from urdfkit.core.suggest import SIMILAR_FILE, has_similar_words, nearest
from urdfkit.mesh.io.facts import BY_SUFFIX
from urdfkit.robot.assets.file_names import is_mistyped, numbers_in, stem, suffix
from urdfkit.robot.assets.mesh_files import MeshFiles, MeshReference, relative_path
from urdfkit.robot.symmetry import pairs
from urdfkit.workspace.references import ResolvedReference

#: Directories of a package that are searched for a missing file.
MAX_DIRECTORIES = 2000

#: Most comparisons of the names of missing files with those of a directory.
MAX_COMPARED = 250_000
#: With this many equal parent directories, one of several files with the same name is certain.
MIN_COMMON_DIRECTORIES = 2
#: Suffixes of models that simulators do not load.
_MODELS = (".3ds", ".3mf", ".blend", ".fbx", ".iges", ".igs", ".sldprt", ".step", ".stp", ".wrl")
#: The package and the path below it in the path of an installed file.
_INSTALLED = r"/share/([^/]+)/(.+)$"


class Suggestion(Record):
    """The file that was probably intended by a reference."""

    reference: str  # the corrected reference
    sure: bool  # True if it is the only candidate


class Candidate(Record):
    """An existing file that a reference may mean."""

    path: str
    is_sure: bool


class MeshSuggestions:
    """Suggests files for the missing ones of a model."""

    def __init__(self, files: MeshFiles) -> None:
        self._files = files
        self._directories = files.resolver.directories
        self._below = cache(lambda base: self._directories.files_below(base, MAX_DIRECTORIES))
        self._names_below = cache(
            lambda base: by_key((_folded_name(path), path) for path in self._below(base))
        )
        self._stems_below = cache(
            lambda base: by_key((stem(path), path) for path in self._below(base) if _is_mesh(path))
        )
        self._stems_in = cache(self._stems_by_numbers)

    def spelling_on_disk(self, mesh: MeshReference) -> Suggestion | None:
        """The reference of a missing file, with upper and lower case as on disk."""
        base, relative = self._expected(mesh.located)
        spelling = self._directories.find_ignoring_case(base, relative)
        if spelling is None:
            return None
        path = os.path.normpath(os.path.join(base, spelling))
        return Suggestion(self._files.reference_to(path, mesh.located), sure=True)

    def model_of_other_format(self, mesh: MeshReference) -> str:
        """The name of the file of which a missing one may be an export; empty if there is none."""
        directory, name = os.path.split(os.path.join(*self._expected(mesh.located)))
        entries = self._directories.entries(directory) or {}
        models = (one for one in sorted(entries) if suffix(one) in _MODELS)
        return next((one for one in models if stem(one) == stem(name)), "")

    def nearest(self, mesh: MeshReference) -> Suggestion | None:
        """The file that was probably intended by a reference to a missing file.

        In this order: the file of the package that an absolute path names, the file at this place
        in the package of the model, a file of another format in the same directory, a file of the
        same name elsewhere in the package, a file of a similar name in the same directory, a file
        of another format elsewhere. It is sure if it is the only candidate and no other link uses
        it. A file whose name resembles the missing files of several links is not offered.
        """
        located = mesh.located
        if suggestion := self._installed(located) or self._in_own_package(located):
            return suggestion
        if self.installed_reference(located):
            return None
        similar = self._similar_name(mesh)
        if similar and not similar.is_sure and self._is_similar_to_several(similar.path):
            similar = None
        candidates = [self._same_name_elsewhere(located), similar]
        if similar and stem(similar.path) == stem(located.relative):
            candidates.reverse()
        candidates.append(self._same_name_elsewhere(located, any_format=True))
        chosen = next(filter(None, candidates), None)
        if chosen is None:
            return None
        reference = self._files.reference_to(chosen.path, located)
        if reference == chosen.path:  # an absolute path is not replaced by another absolute path
            reference = relative_path(chosen.path, self._files.directory)
        return Suggestion(reference, chosen.is_sure and chosen.path not in self._used)

    def _installed(self, located: ResolvedReference) -> Suggestion | None:
        """The file of a package at an absolute path on another computer."""
        if located.scheme != "absolute":
            return None
        known = self._files.resolver.packages.known(self._files.top)
        parts = located.reference.split("/")
        for index in range(len(parts) - 2, 0, -1):
            name, below = parts[index], "/".join(parts[index + 1 :])
            is_installed = parts[index - 1] == "share"
            is_known = name in known and disk.is_file(os.path.join(known[name], below))
            if is_installed or is_known:
                reference = f"package://{name}/{below}"
                if self._files.resolver.locate(reference, self._files.top).path:
                    return Suggestion(reference, sure=True)
        return None

    def installed_reference(self, located: ResolvedReference) -> str:
        """The reference to a file of an installation, if its package is not found; else empty."""
        if located.scheme != "absolute" or not (match := re.search(_INSTALLED, located.reference)):
            return ""
        name, path = match.groups()
        is_known = name in self._files.resolver.packages.known(self._files.top)
        return "" if is_known else f"package://{name}/{path}"

    def _in_own_package(self, located: ResolvedReference) -> Suggestion | None:
        """The file at the same place in the package of the model."""
        own = self._files.resolver.packages.enclosing(self._files.top)
        is_installed = located.scheme == "absolute"
        match = re.search(_INSTALLED, located.reference) if is_installed else None
        name, relative = match.groups() if match else (located.package, located.relative)
        if not own or not name or name == own[0]:
            return None
        reference = f"package://{own[0]}/{relative}"
        path = self._files.resolver.locate(reference, self._files.top).path
        return Suggestion(reference, path not in self._used) if path else None

    def _expected(self, located: ResolvedReference) -> tuple[str, str]:
        """The base directory of a missing file, and its path below it."""
        if located.directory:
            return located.directory, located.relative
        if located.scheme == "relative":
            return self._files.directory, located.relative
        return os.path.split(located.tried[0])

    def _same_name_elsewhere(
        self, located: ResolvedReference, *, any_format: bool = False
    ) -> Candidate | None:
        """The file of the expected name in the package.

        Of several, the only one that shares the most parent directories with the missing file, or
        of these the only one that is nearest to the model, which is not certain. Without a package
        only a file below the parent directory of the model is certain. Of `ur10/visual` and
        `ur10e/visual`, a file in the one is not certain for the other.
        """
        base = located.directory or self._searched(located)
        directory, expected = os.path.split(located.relative)
        by_common: dict[int, list[str]] = {}
        paths = self._names_below(base).get(expected.casefold(), [])
        if any_format:
            paths = [*{*paths, *self._stems_below(base).get(stem(expected), ())}]
        for path in paths:
            common, ours, theirs = _without_common_end(directory, relative_path(path, base))
            # Exclude the same part of another model of the series.
            if not (own := {*numbers_in(ours)}) or {*numbers_in(theirs)} in (set(), own):
                by_common.setdefault(common, []).append(path)
        best = max(by_common, default=0)
        files = by_common.get(best, [])
        is_only = len(files) == 1 and (len(by_common) == 1 or best >= MIN_COMMON_DIRECTORIES)
        here = self._files.directory
        if len(files) > 1:
            by_steps = by_key((relative_path(path, here).count("/"), path) for path in files)
            files = by_steps[min(by_steps)]
        if len(files) != 1:
            return None
        home = located.directory or self._files.resolver.packages.enclosing(self._files.top)
        is_near = bool(home) or is_within(files[0], os.path.dirname(here))
        is_other_part = best > 0 and self._directories.entries(os.path.join(base, directory))
        return Candidate(files[0], is_only and is_near and not (any_format or is_other_part))

    def _searched(self, located: ResolvedReference) -> str:
        """The package of an absolute path, else that of the model, else its workspace."""
        packages = self._files.resolver.packages
        home = packages.enclosing(located.tried[0]) if located.scheme == "absolute" else None
        home = home or packages.enclosing(self._files.top)
        return home[1] if home else packages.workspace(self._files.top)

    def _similar_name(self, mesh: MeshReference) -> Candidate | None:
        """A file of a similar name in the same directory, which is sure if the name is a typo."""
        base, relative = self._expected(mesh.located)
        directory, expected = os.path.split(os.path.normpath(os.path.join(base, relative)))
        stems = self._stems_in(directory).get(tuple(numbers_in(expected)), {})
        if len(stems) * len(self._files.missing) > MAX_COMPARED:
            return None
        name = os.path.splitext(expected)[0]
        close = nearest(name, stems, SIMILAR_FILE)
        if close and not is_mistyped(expected, stems[close]):
            others = self._links - {mesh.link.name}  # a link of that name has the file
            close = nearest(name, stems.keys() - others, SIMILAR_FILE)
        if close is None or not has_similar_words(name, close) or pairs((name, close)):
            return None  # the file for the other side
        path = os.path.join(directory, stems[close])
        return Candidate(path, is_mistyped(expected, stems[close]))

    def _is_similar_to_several(self, path: str) -> bool:
        """True if the name of a file resembles missing files of several links."""
        names = self._links_by_similar_name.get(path, {})
        return bool(names) and not set.intersection(*names.values())

    @cached_property
    def _links_by_similar_name(self) -> dict[str, dict[str, set[str]]]:
        """For each file, the similar names of missing files, and their links."""
        links: dict[str, dict[str, set[str]]] = {}
        for mesh in self._files.missing:
            if similar := self._similar_name(mesh):
                names = links.setdefault(similar.path, {})
                names.setdefault(stem(mesh.located.relative), set()).add(mesh.link.name)
        return links

    @cached_property
    def _links(self) -> set[str]:
        return {mesh.link.name for mesh in self._files.meshes}

    @cached_property
    def _used(self) -> set[str]:
        return {mesh.located.path for mesh in self._files.meshes if mesh.located.path}

    def _stems_by_numbers(self, directory: str) -> dict[tuple[str, ...], dict[str, str]]:
        """The meshes in a directory by their name without suffix, by the numbers in it."""
        stems: dict[tuple[str, ...], dict[str, str]] = {}
        for name, is_directory in (self._directories.entries(directory) or {}).items():
            if not is_directory and _is_mesh(name):
                by_stem = stems.setdefault(tuple(numbers_in(name)), {})
                by_stem[os.path.splitext(name)[0]] = name
        return stems


def _folded_name(path: str) -> str:
    return os.path.basename(path).casefold()


def _is_mesh(path: str) -> bool:
    return suffix(path) in BY_SUFFIX


def _without_common_end(directory: str, path: str) -> tuple[int, str, str]:
    """The number of common trailing directories of two paths, and the remaining parts."""
    ours, theirs = directory.split("/"), path.split("/")[:-1]
    common = 0
    while ours and theirs and ours[-1] == theirs[-1]:
        ours, theirs = ours[:-1], theirs[:-1]
        common += 1
    return common, "/".join(ours), "/".join(theirs)

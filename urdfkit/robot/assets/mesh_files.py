"""The mesh files that a model references: paths, formats, defects, and suggestions."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from functools import cache, cached_property

from urdfkit.core import disk
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.suggest import SIMILAR_FILE, nearest
from urdfkit.mesh.io.facts import BY_SUFFIX, MAX_BYTES, MeshFacts, has_other_up_axis, is_gltf
from urdfkit.robot.assets.file_names import is_mistyped, numbers_in, stem, suffix
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.robot.model import RobotModel
from urdfkit.robot.placed import Placed
from urdfkit.text.document import Attribute, Tag
from urdfkit.workspace.references import ResolvedReference
from urdfkit.workspace.resolve import Resolver

#: Directories of a package that are searched for a missing file.
MAX_DIRECTORIES = 2000

#: Most comparisons of the names of missing files with those of a directory.
MAX_COMPARED = 250_000
#: With this many equal parent directories, one of several files with the same name is certain.
MIN_COMMON_DIRECTORIES = 2
#: The package and the path below it in the path of an installed file.
_INSTALLED = re.compile(r"/share/([^/]+)/(.+)$")


class MeshReference(Record):
    """A reference to a mesh file in a visual or collision."""

    at: Placed[str]  # the file name after expansion
    link: Link  # the link
    role: str  # ``visual`` or ``collision``
    body: Body  # the visual or collision
    located: ResolvedReference  # the resolved file
    facts: MeshFacts | None  # properties of the file's contents; None if the file is missing

    @property
    def who(self) -> str:
        return f"link '{self.link.name}': the {self.role} mesh '{self.at.value}'"

    @property
    def literal(self) -> Attribute | None:
        """The attribute if the source contains this reference literally; a fix can edit it."""
        at = self.at.at
        return at if isinstance(at, Attribute) and at.literal else None


class Suggestion(Record):
    """The file that was probably intended by a reference."""

    reference: str  # the corrected reference
    sure: bool  # True if it is the only candidate


class MeshFiles:
    """The mesh files of a model; each file is located and read once."""

    def __init__(self, model: RobotModel, resolver: Resolver) -> None:
        self.resolver = resolver
        self.top = model.document.sources[0].path
        self._model = model
        self.facts: Callable[[str], MeshFacts] = cache(_facts)
        self._below = cache(lambda base: resolver.directories.files_below(base, MAX_DIRECTORIES))
        self._names_below = cache(
            lambda base: by_key((_folded_name(path), path) for path in self._below(base))
        )
        self._stems_below = cache(
            lambda base: by_key((stem(path), path) for path in self._below(base) if _is_mesh(path))
        )
        self._stems_in = cache(self._stems_by_numbers)
        self._is_ignored_kind = cache(_is_ignored_kind)  # git takes time for each file

    @cached_property
    def meshes(self) -> tuple[MeshReference, ...]:
        """All mesh references, in document order.

        References with an unexpanded ``${`` or ``$(`` are omitted.
        """
        return tuple(
            self._mesh(link, role, body, body.shape.filename)
            for link in self._model.links
            for role, bodies in (("visual", link.visuals), ("collision", link.collisions))
            for body in bodies
            if body.shape
            and body.shape.filename
            and "${" not in body.shape.filename.value
            and "$(" not in body.shape.filename.value
        )

    @cached_property
    def each_file(self) -> tuple[MeshReference, ...]:
        """The first reference to each existing file; symbolic links are resolved."""
        first: dict[str, MeshReference] = {}
        for mesh in self.meshes:
            if mesh.located.path:
                first.setdefault(disk.real(mesh.located.path), mesh)
        return tuple(first.values())

    @cached_property
    def paths(self) -> tuple[str, ...]:
        """The existing mesh files, without repetitions."""
        paths = (mesh.located.path for mesh in self.meshes)
        return tuple(dict.fromkeys(path for path in paths if path is not None))

    def path(self, shape: Shape) -> str | None:
        """The mesh file of a shape; None if it is not a mesh, or the file is missing."""
        return self.find(shape.filename) if shape.filename else None

    def find(self, name: Placed[str]) -> str | None:
        """The file of a mesh or texture; None if it is missing."""
        return self.locate(name).path

    def locate(self, name: Placed[str]) -> ResolvedReference:
        """The resolved reference of a mesh or texture."""
        return self.resolver.locate(name.value, _tag(name).source.path, self.top)

    def has_ambiguous_axes(self, body: Body) -> bool:
        """True for a mesh whose axes programs interpret differently (MSH013)."""
        path = self.path(body.shape) if body.shape else None
        facts = self.facts(path) if path else None
        return facts is not None and (has_other_up_axis(facts) or is_gltf(facts))

    @cached_property
    def missing(self) -> tuple[MeshReference, ...]:
        """References to missing files in known packages."""
        return tuple(
            mesh
            for mesh in self.meshes
            if mesh.located.path is None
            and mesh.located.outside is None
            and (mesh.located.package is None or mesh.located.directory is not None)
            and mesh.located.scheme in ("package", "model", "absolute", "relative")
        )

    @property
    def copies(self) -> list[tuple[MeshReference, MeshReference]]:
        """References to files with the same contents as an earlier file, each with the latter."""
        by_size = by_key(
            (mesh.facts.size, mesh)
            for mesh in self.each_file
            if mesh.facts and not mesh.facts.defect and mesh.facts.size <= MAX_BYTES
        )
        copies = []
        for same_size in by_size.values():
            first: dict[bytes, MeshReference] = {}
            for mesh in same_size if len(same_size) > 1 else ():
                earlier = first.setdefault(_content(mesh), mesh)
                if earlier is not mesh:
                    copies.append((mesh, earlier))
        return copies

    @property
    def ignored(self) -> list[MeshReference]:
        """References to files that git ignores."""
        if not self.each_file:
            return []
        from urdfkit.workspace.gitignore import GitIgnored

        ignored = GitIgnored()
        return [mesh for mesh in self.each_file if mesh.located.path in ignored]

    def is_ignored(self, missing: MeshReference) -> bool:
        """True if git ignores a missing file, and its directory has no file of its kind."""
        return any(
            self._is_ignored_kind(os.path.dirname(path), os.path.splitext(path)[1].lower())
            for path in missing.located.tried
        )

    @property
    def without_package(self) -> dict[str, list[MeshReference]]:
        """References to missing packages, by package name."""
        return by_key(
            (mesh.located.package, mesh)
            for mesh in self.meshes
            if mesh.located.package is not None and mesh.located.directory is None
        )

    def spelling_on_disk(self, mesh: MeshReference) -> Suggestion | None:
        """The reference of a missing file, with upper and lower case as on disk."""
        base, relative = self._expected(mesh.located)
        spelling = self.resolver.directories.find_ignoring_case(base, relative)
        if spelling is None:
            return None
        path = os.path.normpath(os.path.join(base, spelling))
        return Suggestion(self.reference_to(path, mesh.located), sure=True)

    def nearest(self, mesh: MeshReference) -> Suggestion | None:
        """The file that was probably intended by a reference to a missing file.

        In this order: the file of the package that an installed path names, a file of another
        format in the same directory, a file of the same name elsewhere in the package, a file of a
        similar name in the same directory, a file of another format elsewhere. It is sure if it is
        the only candidate and no other link uses it. A file whose name resembles the missing files
        of several links is not offered.
        """
        located = mesh.located
        if suggestion := self._installed(located):
            return suggestion
        similar = self._similar_name(located)
        links = self._links_by_similar_name.get(similar[0], {}).values()
        if similar[0] is not None and not similar[1] and not set.intersection(*links):
            similar = None, False
        candidates = [self._same_name_elsewhere(located), similar]
        if similar[0] is not None and stem(similar[0]) == stem(located.relative):
            candidates.reverse()
        candidates.append(self._same_name_elsewhere(located, any_format=True))
        path, sure = next((pair for pair in candidates if pair[0] is not None), (None, False))
        if path is None:
            return None
        sure = sure and path not in self._used
        reference = self.reference_to(path, located)
        # An absolute path is not replaced by another absolute path.
        portable = _relative(path, self._directory) if reference == path else reference
        return Suggestion(portable, sure)

    def _installed(self, located: ResolvedReference) -> Suggestion | None:
        """The file of a package at an absolute path of its installation on another computer."""
        if located.scheme != "absolute" or not (match := _INSTALLED.search(located.reference)):
            return None
        reference = f"package://{match[1]}/{match[2]}"
        path = self.resolver.locate(reference, self.top).path
        return Suggestion(reference, sure=True) if path else None

    def reference_to(self, path: str, like: ResolvedReference) -> str:
        """A reference to a file, of the same scheme as another reference if possible."""
        if like.directory:
            return f"{like.scheme}://{like.package}/{_relative(path, like.directory)}"
        package = self.resolver.packages.enclosing(path)
        if like.scheme != "relative" and package:
            return f"package://{package[0]}/{_relative(path, package[1])}"
        return _relative(path, self._directory) if like.scheme == "relative" else path

    @property
    def _directory(self) -> str:
        return os.path.dirname(os.path.abspath(self.top))

    @cached_property
    def _links_by_similar_name(self) -> dict[str | None, dict[str, set[str]]]:
        """For each file, the similar names of missing files, and their links."""
        links: dict[str | None, dict[str, set[str]]] = {}
        for mesh in self.missing:
            path, _ = self._similar_name(mesh.located)
            name = stem(mesh.located.relative)
            links.setdefault(path, {}).setdefault(name, set()).add(mesh.link.name)
        return links

    @cached_property
    def _used(self) -> set[str]:
        return {mesh.located.path for mesh in self.meshes if mesh.located.path}

    def _mesh(self, link: Link, role: str, body: Body, filename: Placed[str]) -> MeshReference:
        located = self.locate(filename)
        facts = self.facts(located.path) if located.path else None
        return MeshReference(filename, link, role, body, located, facts)

    def _expected(self, located: ResolvedReference) -> tuple[str, str]:
        """The base directory of a missing file, and its path below it."""
        if located.directory:
            return located.directory, located.relative
        if located.scheme == "relative":
            return self._directory, located.relative
        return os.path.split(located.tried[0])

    def _same_name_elsewhere(
        self, located: ResolvedReference, *, any_format: bool = False
    ) -> tuple[str | None, bool]:
        """The file of the expected name in the package, and whether it is certain.

        Of several, the only one that shares the most parent directories with the missing file, or
        of these the only one that is nearest to the model, which is not certain.
        """
        base = located.directory or self._searched(located)
        directory, expected = os.path.split(located.relative)
        by_common: dict[int, list[str]] = {}
        paths = self._names_below(base).get(expected.casefold(), [])
        if any_format:
            paths = [*{*paths, *self._stems_below(base).get(stem(expected), ())}]
        for path in paths:
            common, ours, theirs = _without_common_end(directory, _relative(path, base))
            # Exclude the same part of another model of the series.
            if not (own := numbers_in(ours)) or numbers_in(theirs) in ([], own):
                by_common.setdefault(common, []).append(path)
        best = max(by_common, default=0)
        files = by_common.get(best, [])
        is_only = len(files) == 1 and (len(by_common) == 1 or best >= MIN_COMMON_DIRECTORIES)
        if len(files) > 1:
            by_steps = by_key((_relative(path, self._directory).count("/"), path) for path in files)
            files = by_steps[min(by_steps)]
        return files[0] if len(files) == 1 else None, is_only and not any_format

    def _searched(self, located: ResolvedReference) -> str:
        """The package of an absolute path, else that of the model, else its workspace."""
        packages = self.resolver.packages
        home = packages.enclosing(located.tried[0]) if located.scheme == "absolute" else None
        home = home or packages.enclosing(self.top)
        return home[1] if home else packages.workspace(self.top)

    def _similar_name(self, located: ResolvedReference) -> tuple[str | None, bool]:
        """A file of a similar name in the same directory, and whether the name is a typo."""
        base, relative = self._expected(located)
        directory, expected = os.path.split(os.path.normpath(os.path.join(base, relative)))
        stems = self._stems_in(directory).get(tuple(numbers_in(expected)), {})
        if len(stems) * len(self.missing) > MAX_COMPARED:
            return None, False
        close = nearest(os.path.splitext(expected)[0], stems, SIMILAR_FILE)
        if close is None:
            return None, False
        return os.path.join(directory, stems[close]), is_mistyped(expected, stems[close])

    def _stems_by_numbers(self, directory: str) -> dict[tuple[str, ...], dict[str, str]]:
        """The meshes in a directory by their name without suffix, by the numbers in it."""
        stems: dict[tuple[str, ...], dict[str, str]] = {}
        for name, is_directory in (self.resolver.directories.entries(directory) or {}).items():
            if not is_directory and _is_mesh(name):
                by_stem = stems.setdefault(tuple(numbers_in(name)), {})
                by_stem[os.path.splitext(name)[0]] = name
        return stems


def _is_mesh(path: str) -> bool:
    return suffix(path) in BY_SUFFIX


def _folded_name(path: str) -> str:
    return os.path.basename(path).casefold()


def _facts(path: str) -> MeshFacts:
    from urdfkit.mesh.io.sniff import sniff_file

    return sniff_file(path)


def _without_common_end(directory: str, path: str) -> tuple[int, str, str]:
    """The number of common trailing directories of two paths, and the remaining parts."""
    ours, theirs = directory.split("/"), path.split("/")[:-1]
    common = 0
    while ours and theirs and ours[-1] == theirs[-1]:
        ours, theirs = ours[:-1], theirs[:-1]
        common += 1
    return common, "/".join(ours), "/".join(theirs)


def _content(mesh: MeshReference) -> bytes:
    """The contents of a file; its unique path if it is unreadable."""
    path = mesh.located.path or ""
    try:
        return disk.read(path)
    except OSError:
        return path.encode("utf-8", "surrogateescape")


def _relative(path: str, directory: str) -> str:
    return os.path.relpath(path, directory).replace(os.sep, "/")


def _tag(placed: Placed[str]) -> Tag:
    """The tag that contains the text of a value."""
    at = placed.at
    if isinstance(at, Attribute):
        return at.written_in or at.element.tag_at
    return at.tag_at


def _is_ignored_kind(directory: str, suffix: str) -> bool:
    """True if git ignores the files with a suffix in a directory, and it has none."""
    from urdfkit.workspace.gitignore import GitIgnored

    names = disk.names(directory) if disk.is_directory(directory) else []
    is_empty = not any(name.lower().endswith(suffix) for name in names)
    return is_empty and os.path.join(directory, f"mesh{suffix}") in GitIgnored()

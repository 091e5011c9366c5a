"""The mesh files that a model names: their places, formats and defects, and suggestions."""

from __future__ import annotations

import os
from functools import cached_property

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.suggest import SIMILAR_FILE, nearest
from urdfkit.mesh.io.facts import BY_SUFFIX, MAX_BYTES, MeshFacts, has_other_up_axis, is_gltf
from urdfkit.robot.assets.file_names import is_mistyped, numbers_in, stem, suffix
from urdfkit.robot.model import Body, Link, Placed, RobotModel, Shape
from urdfkit.text.document import Attribute, Tag
from urdfkit.workspace.references import ResolvedReference
from urdfkit.workspace.resolve import Resolver

#: Directories of a package that are searched for a file of the wanted name.
MAX_DIRECTORIES = 2000
#: Directories of a missing file that lead to one of several files of its name for sure.
MIN_COMMON_DIRECTORIES = 2


class MeshReference(Record):
    """A mesh that a visual or a collision names."""

    at: Placed[str]  # the file name as it is after expansion
    link: Link  # the link
    role: str  # ``visual`` or ``collision``
    body: Body  # the visual or collision
    located: ResolvedReference  # where it leads
    facts: MeshFacts | None  # what the file's bytes say; None if there is no file

    @property
    def who(self) -> str:
        return f"link '{self.link.name}': the {self.role} mesh '{self.at.value}'"

    @property
    def literal(self) -> Attribute | None:
        """The attribute, if the source holds this very reference and a fix may edit it."""
        at = self.at.at
        return at if isinstance(at, Attribute) and at.literal else None


class Suggestion(Record):
    """A file that a reference probably means."""

    reference: str  # to write instead
    path: str  # the file that it leads to
    sure: bool  # True if it is the only candidate


class MeshFiles:
    """The files of one model; every file is found and read once."""

    def __init__(self, model: RobotModel, resolver: Resolver) -> None:
        self.resolver = resolver
        self.top = model.document.sources[0].path
        self._model = model
        self._facts: dict[str, MeshFacts] = {}
        self._below: dict[str, list[str]] = {}

    @cached_property
    def meshes(self) -> tuple[MeshReference, ...]:
        """Every mesh reference, in the order of the document.

        References with an unexpanded ``${`` or ``$(`` are left out: they name no file yet.
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
        """The first reference to each file that is there; symbolic links count once."""
        first: dict[str, MeshReference] = {}
        for mesh in self.meshes:
            if mesh.located.path:
                first.setdefault(disk.real(mesh.located.path), mesh)
        return tuple(first.values())

    @cached_property
    def paths(self) -> tuple[str, ...]:
        """The mesh files that are there, each once."""
        found = (mesh.located.path for mesh in self.meshes)
        return tuple(dict.fromkeys(path for path in found if path is not None))

    def path(self, shape: Shape) -> str | None:
        """The file that a shape names; None if it is no mesh, or there is no such file."""
        return self.find(shape.filename) if shape.filename else None

    def find(self, name: Placed[str]) -> str | None:
        """The file that a mesh or a texture names; None if there is no such file."""
        return self.locate(name).path

    def locate(self, name: Placed[str]) -> ResolvedReference:
        """What the name of a mesh or a texture leads to."""
        return self.resolver.locate(name.value, _tag(name).source.path, self.top)

    def facts(self, path: str) -> MeshFacts:
        if path not in self._facts:
            from urdfkit.mesh.io.sniff import sniff_file

            self._facts[path] = sniff_file(path)
        return self._facts[path]

    def has_ambiguous_axes(self, body: Body) -> bool:
        """True for a mesh whose axes programs read differently (MSH013)."""
        path = self.path(body.shape) if body.shape else None
        facts = self.facts(path) if path else None
        return facts is not None and (has_other_up_axis(facts) or is_gltf(facts))

    @property
    def missing(self) -> tuple[MeshReference, ...]:
        """The references that lead to no file, although their package is known."""
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
        """The references to a file with the content of an earlier one, and the latter."""
        by_size: dict[int, list[MeshReference]] = {}
        for mesh in self.each_file:
            if mesh.facts and not mesh.facts.defect and mesh.facts.size <= MAX_BYTES:
                by_size.setdefault(mesh.facts.size, []).append(mesh)
        found = []
        for alike in by_size.values():
            first: dict[bytes, MeshReference] = {}
            for mesh in alike if len(alike) > 1 else ():
                earlier = first.setdefault(_content(mesh), mesh)
                if earlier is not mesh:
                    found.append((mesh, earlier))
        return found

    @property
    def ignored(self) -> list[MeshReference]:
        """The references to files that git leaves out of the repository that they lie in."""
        if not self.each_file:
            return []
        from urdfkit.workspace.gitignore import GitIgnored

        ignored = GitIgnored()
        return [mesh for mesh in self.each_file if mesh.located.path in ignored]

    @property
    def without_package(self) -> dict[str, list[MeshReference]]:
        """The references whose package is not found, by its name."""
        found: dict[str, list[MeshReference]] = {}
        for mesh in self.meshes:
            if mesh.located.package is not None and mesh.located.directory is None:
                found.setdefault(mesh.located.package, []).append(mesh)
        return found

    def spelling_on_disk(self, mesh: MeshReference) -> Suggestion | None:
        """The reference of a missing file, with upper and lower case as on disk."""
        base, relative = self._expected(mesh.located)
        spelling = self.resolver.directories.find_ignoring_case(base, relative)
        if spelling is None:
            return None
        path = os.path.normpath(os.path.join(base, spelling))
        return Suggestion(self.reference_to(path, mesh.located), path, sure=True)

    def nearest(self, mesh: MeshReference) -> Suggestion | None:
        """The file that a reference to a missing one probably means.

        One of another format in the same directory, else a file of the same name elsewhere in the
        package, else one of a similar name in the same directory, else one of another format
        elsewhere. It is sure if it is the only candidate and no other link uses it. A file whose
        name is like those of the missing ones of several links is not offered.
        """
        located = mesh.located
        similar = self._similar_name(located)
        links = self._links_by_name_like.get(similar[0], {}).values()
        if not similar[1] and not set.intersection(*links):
            similar = None, False
        found = [self._same_name_elsewhere(located), similar]
        if similar[0] is not None and stem(similar[0]) == stem(located.relative):
            found.reverse()
        found.append(self._same_name_elsewhere(located, any_format=True))
        path, sure = next((one for one in found if one[0] is not None), (None, False))
        if path is None:
            return None
        sure = sure and path not in self._used
        reference = self.reference_to(path, located)
        # The path of one machine is not replaced by that of another one.
        portable = _relative(path, self._directory) if reference == path else reference
        return Suggestion(portable, path, sure)

    def reference_to(self, path: str, like: ResolvedReference) -> str:
        """A reference to a file, of the same sort as another one if it can be."""
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
    def _links_by_name_like(self) -> dict[str | None, dict[str, set[str]]]:
        """For each file, the names of missing files that its own is like, and their links."""
        found: dict[str | None, dict[str, set[str]]] = {}
        for mesh in self.missing:
            path, _ = self._similar_name(mesh.located)
            name = stem(mesh.located.relative)
            found.setdefault(path, {}).setdefault(name, set()).add(mesh.link.name)
        return found

    @cached_property
    def _used(self) -> set[str]:
        return {mesh.located.path for mesh in self.meshes if mesh.located.path}

    def _mesh(self, link: Link, role: str, body: Body, filename: Placed[str]) -> MeshReference:
        located = self.resolver.locate(filename.value, _tag(filename).source.path, self.top)
        facts = self.facts(located.path) if located.path else None
        return MeshReference(filename, link, role, body, located, facts)

    def _expected(self, located: ResolvedReference) -> tuple[str, str]:
        """The directory below which a missing file should be, and its path there."""
        if located.directory:
            return located.directory, located.relative
        if located.scheme == "relative":
            return self._directory, located.relative
        return os.path.split(located.tried[0])

    def _same_name_elsewhere(
        self, located: ResolvedReference, *, any_format: bool = False
    ) -> tuple[str | None, bool]:
        """The file of the wanted name in the package, and whether it certainly is the wanted one.

        Of several the one in the most directories of the wanted names; none if that is not one.
        """
        base = located.directory
        if base is None:
            package = self.resolver.packages.enclosing(self.top)
            base = package[1] if package else self.resolver.packages.workspace(self.top)
        if base not in self._below:
            self._below[base] = self.resolver.directories.files_below(base, MAX_DIRECTORIES)
        directory, wanted = os.path.split(located.relative)
        found: dict[int, list[str]] = {}
        for path in self._below[base]:
            name = os.path.basename(path)
            if name.casefold() != wanted.casefold() and not (
                any_format and suffix(name) in BY_SUFFIX and stem(name) == stem(wanted)
            ):
                continue
            common, ours, theirs = _without_common_end(directory, _relative(path, base))
            # Not the same part of another model of the series.
            if not (own := numbers_in(ours)) or numbers_in(theirs) in ([], own):
                found.setdefault(common, []).append(path)
        best = max(found, default=0)
        if len(found.get(best, ())) != 1:
            return None, False
        is_only = len(found) == 1 or best >= MIN_COMMON_DIRECTORIES
        return found[best][0], is_only and not any_format

    def _similar_name(self, located: ResolvedReference) -> tuple[str | None, bool]:
        """A mesh file of a similar name in the same directory, and whether that is a typo."""
        base, relative = self._expected(located)
        directory, wanted = os.path.split(os.path.normpath(os.path.join(base, relative)))
        entries = self.resolver.directories.entries(directory) or {}
        numbers = numbers_in(wanted)
        meshes = [
            name
            for name, is_directory in entries.items()
            if not is_directory and suffix(name) in BY_SUFFIX and numbers_in(name) == numbers
        ]
        # Without the endings, which are alike anyway.
        stems = {os.path.splitext(name)[0]: name for name in meshes}
        close = nearest(os.path.splitext(wanted)[0], stems, SIMILAR_FILE)
        if close is None:
            return None, False
        return os.path.join(directory, stems[close]), is_mistyped(wanted, stems[close])


def _without_common_end(directory: str, path: str) -> tuple[int, str, str]:
    """How many directories a wanted directory and that of a path end in alike, and what is left."""
    ours, theirs = directory.split("/"), path.split("/")[:-1]
    common = 0
    while ours and theirs and ours[-1] == theirs[-1]:
        ours, theirs = ours[:-1], theirs[:-1]
        common += 1
    return common, "/".join(ours), "/".join(theirs)


def _content(mesh: MeshReference) -> bytes:
    """The bytes of a file; its path where they cannot be read, which equals no other."""
    path = mesh.located.path or ""
    try:
        return disk.read(path)
    except OSError:
        return path.encode("utf-8", "surrogateescape")


def _relative(path: str, directory: str) -> str:
    return os.path.relpath(path, directory).replace(os.sep, "/")


def _tag(placed: Placed[str]) -> Tag:
    """The tag that holds the text of a value."""
    at = placed.at
    if isinstance(at, Attribute):
        return at.written_in or at.element.tag_at
    return at.tag_at

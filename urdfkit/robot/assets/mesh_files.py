"""The mesh files that a model references: paths, formats, defects, and suggestions."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache, cached_property

from urdfkit.core import disk
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.mesh.io.facts import MAX_BYTES, MeshFacts, has_other_up_axis, is_gltf
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.robot.model import RobotModel
from urdfkit.robot.placed import Placed
from urdfkit.text.document import Attribute, Tag
from urdfkit.text.grammar import is_expression
from urdfkit.workspace.references import ResolvedReference
from urdfkit.workspace.resolve import Resolver


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


class MeshFiles:
    """The mesh files of a model; each file is located and read once."""

    def __init__(self, model: RobotModel, resolver: Resolver) -> None:
        self.resolver = resolver
        self.top = model.document.sources[0].path
        self._model = model
        self.facts: Callable[[str], MeshFacts] = cache(_facts)
        self._is_ignored_kind = cache(_is_ignored_kind)  # git takes time for each file

    @cached_property
    def meshes(self) -> tuple[MeshReference, ...]:
        """All mesh references, in document order.

        References with an unexpanded ``${`` or ``$(`` are omitted.
        """
        return tuple(
            self._mesh(link, body.at.tag, body, body.file)
            for link in self._model.links
            for body in link.bodies
            if body.file and not is_expression(body.file.value)
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

    def reference_to(self, path: str, like: ResolvedReference) -> str:
        """A reference to a file, of the same scheme as another reference if possible."""
        if like.directory:
            return f"{like.scheme}://{like.package}/{relative_path(path, like.directory)}"
        package = self.resolver.packages.enclosing(path)
        if like.scheme != "relative" and package:
            return f"package://{package[0]}/{relative_path(path, package[1])}"
        return relative_path(path, self.directory) if like.scheme == "relative" else path

    @property
    def directory(self) -> str:
        """The directory of the model, below which relative references are found."""
        return os.path.dirname(os.path.abspath(self.top))

    def _mesh(self, link: Link, role: str, body: Body, filename: Placed[str]) -> MeshReference:
        located = self.locate(filename)
        facts = self.facts(located.path) if located.path else None
        return MeshReference(filename, link, role, body, located, facts)


def _facts(path: str) -> MeshFacts:
    from urdfkit.mesh.io.sniff import sniff_file

    return sniff_file(path)


def _content(mesh: MeshReference) -> bytes:
    """The contents of a file; its unique path if it is unreadable."""
    path = mesh.located.path or ""
    data = disk.contents(path)
    return os.fsencode(path) if data is None else data


def relative_path(path: str, directory: str) -> str:
    """A path from a directory, with slashes."""
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

    names = disk.names_or_empty(directory)
    is_empty = not any(name.lower().endswith(suffix) for name in names)
    return is_empty and os.path.join(directory, f"mesh{suffix}") in GitIgnored()

"""A robot for another machine or program: a URDF with all of its files."""

from __future__ import annotations

import hashlib
import json
import os
import re
from collections.abc import Container, Iterable, Iterator, Mapping
from typing import Any

from urdfkit import __version__
from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.words import few
from urdfkit.errors import MissingLibrary, UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.bundle.consumers import Consumer
from urdfkit.output.bundle.meshes import BundledFile, FreeNames, bundled
from urdfkit.output.bundle.package import package_files
from urdfkit.output.bundle.robot import (
    Renamed,
    mesh_references,
    references,
    rewritten,
    texture_references,
)
from urdfkit.robot.placed import Placed
from urdfkit.text.source import Span, shown

#: The manifest of a bundle; it marks a directory as a bundle.
MANIFEST = "bundle.json"
VERSION = 1
#: Most files that an error names, besides the first.
_MAX_NAMED = 2


class ManifestEntry(Record):
    """Manifest entry of a file in a bundle."""

    path: str  # in the bundle, with ``/``
    size: int  # in bytes
    sha256: str  # of its contents
    source: str  # original file, relative to the workspace; empty for a new file
    change: str  # difference from the original; empty for a copy


class Bundle:
    """A robot and all files that it needs, for one program.

    Raises:
        UrdfkitError: the robot references missing files.
    """

    def __init__(self, robot: Context, consumer: Consumer) -> None:
        self._robot = robot
        self._consumer = consumer
        self._paths = located_files(robot, references(robot.model))
        #: Name of the robot, without characters that are invalid in file and package names.
        self.name = re.sub(r"[^a-z0-9_]+", "_", robot.model.name.lower()).strip("_") or "robot"
        #: Path of the robot in the bundle.
        self.urdf = f"{'urdf/' if consumer.is_package else ''}{self.name}.urdf"
        #: Manifest entries; complete when all `files` were read.
        self.contents: list[ManifestEntry] = []
        self.renamed: tuple[Renamed, ...] = ()  # changed references; complete then, too
        #: Paths of elements and values that still refer to other files; complete then, too.
        self.outside: tuple[tuple[str, str], ...] = ()

    def files(self) -> Iterator[BundledFile]:
        """The files, each read or converted when needed; the last one is the manifest.

        Raises:
            UrdfkitError: a file is broken, or cannot be converted to a supported format.
        """
        for file in self._files():
            if "\\" in file.path:  # a path separator on Windows
                raise UrdfkitError(
                    f"{file.path}: a name with a backslash cannot be bundled; rename it"
                )
            digest = hashlib.sha256(file.data).hexdigest()
            source = self._shown(file.source)
            self.contents.append(
                ManifestEntry(file.path, len(file.data), digest, source, file.change)
            )
            yield file
        text = json.dumps(self._manifest(), indent=1, ensure_ascii=False) + "\n"
        yield BundledFile(MANIFEST, text.encode("utf-8", "backslashreplace"), "")

    def _files(self) -> Iterator[BundledFile]:
        names: dict[str, str] = {}  # in the bundle, by path
        stems = FreeNames()
        yield from self._meshes(names, stems)
        yield from self._textures(names, stems)
        prefix = f"package://{self.name}/" if self._consumer.is_package else ""

        def new_name(reference: Placed[str]) -> str:
            return prefix + names[self._paths[id(reference)]]

        text, self.renamed, self.outside = rewritten(
            self._robot, new_name, for_mujoco=self._consumer.name == "mujoco"
        )
        yield BundledFile(self.urdf, text, self._robot.source.path)
        if self._consumer.is_package:
            directories = {path.partition("/")[0] for path in (*names.values(), self.urdf)}
            yield from package_files(self.name, self._robot, sorted(directories))

    def _meshes(self, names: dict[str, str], stems: FreeNames) -> Iterator[BundledFile]:
        """The mesh files; their names in the bundle are added to ``names``."""
        model = self._robot.model
        visuals = {self._paths[id(body.file)] for body in model.visuals if body.file}
        yield from bundled_meshes(
            self._robot, mesh_references(model), self._paths, names, self._consumer, stems, visuals
        )

    def _textures(self, names: dict[str, str], stems: FreeNames) -> Iterator[BundledFile]:
        """The images; their names in the bundle are added to ``names``."""
        for reference in texture_references(self._robot.model):
            path = self._paths[id(reference)]
            if path not in names:
                suffix = os.path.splitext(path)[1]
                names[path] = f"textures/{stems.take_stem(path)}{suffix}"
                yield BundledFile(names[path], disk.read(path), path)

    @property
    def new_references(self) -> dict[int, str]:
        """The references in the bundle by ``id`` of the original ones; complete then, too."""
        pairs = zip(references(self._robot.model), self.renamed, strict=True)
        return {id(reference): renamed.new for reference, renamed in pairs}

    def _manifest(self) -> dict[str, Any]:
        return {
            "version": VERSION,
            "urdfkit": __version__,
            "robot": self._robot.model.name,
            "urdf": self.urdf,
            "source": self._shown(self._robot.source.path),
            "arguments": dict(self._robot.arguments),
            "for": self._consumer.name,
            "files": [entry._asdict() for entry in self.contents],
            "references": [
                {
                    "element": reference.element,
                    "file": self._shown(reference.span.source.path),
                    "line": reference.span.line,
                    "old": reference.old,
                    "new": reference.new,
                }
                for reference in self.renamed
            ],
            "outside": [{"element": path, "value": value} for path, value in self.outside],
        }

    def _shown(self, path: str) -> str:
        """A path relative to the directory above the workspace or package of the file."""
        if not path:
            return ""
        path = os.path.abspath(path)
        packages = self._robot.resolver.packages
        package = packages.enclosing(path)
        if package:
            name, directory = package
            return f"{name}/{os.path.relpath(path, directory)}".replace(os.sep, "/")
        near = packages.workspace(self._robot.source.path)
        relative = os.path.relpath(path, near).replace(os.sep, "/")
        return os.path.basename(path) if relative.startswith("../") else relative


def bundled_meshes(
    robot: Context,
    references: Iterable[Placed[str]],
    paths: Mapping[int, str],
    names: dict[str, str],
    consumer: Consumer,
    stems: FreeNames,
    visuals: Container[str],
) -> Iterator[BundledFile]:
    """The bundled files of mesh references, each once.

    Args:
        paths: of the files, by ``id`` of their reference.
        names: receives the names in the bundle, by path.
        visuals: paths of the files that visuals use.

    Raises:
        UrdfkitError: a mesh is broken, or cannot be converted to a supported format.
    """
    for reference in references:
        path = paths[id(reference)]
        if path in names:
            continue
        mesh, stem = robot.files.facts(path), stems.take_stem(path)
        try:
            if mesh.defect:
                raise UrdfkitError(f"{shown(path)}: {mesh.defect.reason}")
            for file in bundled(path, mesh, consumer, stem, is_visual=path in visuals):
                names.setdefault(path, file.path)  # materials and images follow the mesh
                yield file
        except MissingLibrary:
            raise
        except UrdfkitError as error:
            hint = f"see 'urdfkit check {shown(robot.source.path)}'"
            raise UrdfkitError(f"{reference.span}: {error}; {hint}") from error


def located_files(robot: Context, references: Iterable[Placed[str]]) -> dict[int, str]:
    """Paths of files by ``id`` of their reference: equal texts may refer to different files.

    Raises:
        UrdfkitError: files are missing, or outside the workspace.
    """
    paths: dict[int, str] = {}
    missing: dict[str, Span] = {}
    outside: dict[str, Span] = {}
    for reference in references:
        located = robot.files.locate(reference)
        if located.path is not None:
            paths[id(reference)] = located.path
        else:
            (outside if located.outside else missing).setdefault(reference.value, reference.span)
    reasons = [
        *_reason(missing, "does not exist", "neither do"),
        *_reason(outside, "is outside the workspace", "so are"),
    ]
    if not reasons:
        return paths
    raise UrdfkitError(f"{'; '.join(reasons)}; see 'urdfkit check {shown(robot.source.path)}'")


def _reason(files: dict[str, Span], defect: str, of_others: str) -> Iterator[str]:
    """Why files cannot be used: the first one with its place, and some of the others."""
    if files:
        (first, span), *others = files.items()
        more = f", {of_others} {few([name for name, _ in others], _MAX_NAMED)}" if others else ""
        yield f"{span}: '{first}' {defect}{more}"

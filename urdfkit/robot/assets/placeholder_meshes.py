"""Placeholder meshes for missing or broken files.

A broken file is salvaged if most of it is readable. Otherwise the names of file and link determine
a real part (a lidar, a camera, a wheel), and the other shapes of the link its pose and size;
without such a name, these shapes are copied. The result states its source.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.io.sniff import sniff_file
from urdfkit.mesh.parts import RealPart
from urdfkit.mesh.writers import SUFFIXES, require_replaceable, write
from urdfkit.robot import Robot
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.assets.placeholder_shapes import placeholder_shape
from urdfkit.robot.assets.target_bounds import BUILDABLE, is_buildable
from urdfkit.workspace.references import ResolvedReference
from urdfkit.workspace.resolve import OUTSIDE

#: A broken file is salvaged if this part of its triangles is readable.
_MIN_READABLE = 0.5


class GeneratedMesh(Record):
    """A mesh generated for a file."""

    path: str  # expected path of the file
    references: tuple[MeshReference, ...]  # references to the file
    defect: str  # predicate on the file, such as ``does not exist``
    mesh: Mesh  # in the units of the file: the scale of the reference applies to it
    reason: str  # what was generated and why

    def write(self) -> list[str]:
        """Write the file and the files that it references; missing directories are created.

        Returns:
            The paths, the mesh file first.

        Raises:
            UrdfkitError: it cannot be written.
        """
        return write(self.mesh, self.path)


class NotGenerated(Record):
    """A file for which no mesh can be generated, and the reason."""

    path: str
    defect: str
    reason: str


class GeneratedMeshes(Record):
    """The generated meshes for missing and broken files, and the files without one."""

    generated: tuple[GeneratedMesh, ...]
    not_generated: tuple[NotGenerated, ...]

    @classmethod
    def of(cls, results: Sequence[GeneratedMesh | NotGenerated]) -> GeneratedMeshes:
        generated = tuple(result for result in results if isinstance(result, GeneratedMesh))
        return cls(
            generated, tuple(result for result in results if isinstance(result, NotGenerated))
        )


class NoSuchMesh(UrdfkitError):
    """No shape of the robot references the mesh."""


class NoSuchSize(UrdfkitError):
    """No part can be generated with such edges."""


def generate_missing(robot: Robot) -> GeneratedMeshes:
    """Generate a mesh for each missing, empty or broken file of a robot.

    Nothing is written: see `GeneratedMesh.write`.
    """
    return GeneratedMeshes.of([_make(robot, *unusable_file) for unusable_file in unusable(robot)])


def generate(
    robot: Robot,
    reference: str,
    *,
    part: RealPart | None = None,
    size: Vector | None = None,
    force: bool = False,
) -> GeneratedMesh | NotGenerated:
    """Generate a mesh for a file that a robot references.

    Args:
        reference: the ``filename`` as written.
        part: the part to generate; chosen by the names if None.
        size: edges in m, along the axes of the visual or collision; derived from the link if None.

    Raises:
        NoSuchMesh: no shape of the robot has this reference.
        NoSuchSize: an edge is out of bounds.
        SoundMesh: the file is sound and is not replaced.
    """
    _require_buildable(size)
    references = tuple(mesh for mesh in robot.files.meshes if mesh.at.value == reference)
    if not references:
        from urdfkit.core.suggest import did_you_mean

        hint = did_you_mean(reference, [mesh.at.value for mesh in robot.files.meshes])
        raise NoSuchMesh(f"no shape of the robot references '{reference}'{hint}")
    path, defect = _place(references[0])
    if not force:
        require_replaceable(path)
    return _make(robot, path, references, defect or "is to be replaced", part, size)


def generate_part(
    path: str, part: RealPart, size: Vector | None = None, *, force: bool = False
) -> GeneratedMesh:
    """Generate a part for a file that no robot references yet.

    Args:
        size: edges in m, along the axes of the part; the true size if None.

    Raises:
        NoSuchSize: an edge is out of bounds.
        SoundMesh: the file is sound and is not replaced.
    """
    _require_buildable(size)
    if not force:
        require_replaceable(path)
    facts = sniff_file(path) if disk.exists(path) else None
    defect = facts.defect.reason if facts and facts.defect else "does not exist"
    text = "{:g} x {:g} x {:g} m".format(*(size or part.size))
    return GeneratedMesh(path, (), defect, part.build(size), f"{part.name}, {text}: as requested")


def _require_buildable(size: Vector | None) -> None:
    """Check that a solid of a size can be built.

    Raises:
        NoSuchSize: an edge is out of bounds.
    """
    if size is not None and not is_buildable(size):
        edges, (least, most) = "{:g} x {:g} x {:g} m".format(*size), BUILDABLE
        raise NoSuchSize(f"{edges}: every edge must be from {least:g} to {most:g} m")


def unusable(robot: Robot) -> Iterator[tuple[str, tuple[MeshReference, ...], str]]:
    """The missing or broken files: path, references, and defect."""
    grouped: dict[str, list[MeshReference]] = {}
    defects: dict[str, str] = {}
    for mesh in robot.files.meshes:
        path, defect = _place(mesh)
        if defect:
            grouped.setdefault(path, []).append(mesh)
            defects[path] = defect
    for path, references in grouped.items():
        yield path, tuple(references), defects[path]


def _place(mesh: MeshReference) -> tuple[str, str]:
    """The expected path of a referenced file, and its defect; empty if it is sound."""
    located = mesh.located
    if located.outside is not None:
        return located.outside, ""
    if located.path is None:
        return (located.tried[0] if located.tried else located.reference), "does not exist"
    return located.path, mesh.facts.defect.reason if mesh.facts and mesh.facts.defect else ""


def _make(
    robot: Robot,
    path: str,
    references: tuple[MeshReference, ...],
    defect: str,
    part: RealPart | None = None,
    size: Vector | None = None,
) -> GeneratedMesh | NotGenerated:
    if reason := _why_unwritable(robot, path, references[0].located, defect):
        return NotGenerated(path, defect, reason)
    facts = references[0].facts
    if part is None and size is None and facts is not None and facts.defect:
        from urdfkit.mesh.io.salvage import salvage

        salvaged = salvage(path)
        if salvaged is not None and salvaged.share >= _MIN_READABLE:
            lost = f" ({'; '.join(salvaged.mesh.losses)})" if salvaged.mesh.losses else ""
            reason = f"salvaged: {salvaged}{lost}"
            return GeneratedMesh(path, references, defect, salvaged.mesh, reason)
    shape = placeholder_shape(robot, references[0], part, size)
    if shape is None:
        reason = "its name and its link define neither a type nor a size"
        return NotGenerated(path, defect, reason)
    return GeneratedMesh(path, references, defect, *shape)


def _why_unwritable(robot: Robot, path: str, located: ResolvedReference, defect: str) -> str:
    """Why no mesh can be written for a file; empty if one can."""
    if located.package is not None and located.directory is None:
        return f"package '{located.package}' not found; pass its directory with --package"
    if located.scheme not in ("package", "model", "absolute", "relative"):
        return f"'{located.scheme}://' is not a file URI"
    if not robot.files.resolver.admits(path):
        return f"{OUTSIDE}: not written"
    if "Git LFS" in defect:
        return "run 'git lfs pull', which fetches the mesh itself"
    if os.path.splitext(path)[1].lower() not in SUFFIXES:
        return f"only {', '.join(SUFFIXES)} can be written"
    return ""

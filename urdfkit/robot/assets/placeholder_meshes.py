"""Placeholder meshes for files that are missing or broken.

What is left of a broken file is kept where it is most of it. Else the names of file and link say
a real part (a lidar, a camera, a wheel), and the other shapes of the link its place and size; where
no name does, those shapes themselves are taken. Nothing here guesses without saying so.
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
from urdfkit.workspace.resolve import OUTSIDE

#: A broken file is salvaged if this part of its triangles is left.
_ENOUGH = 0.5


class GeneratedMesh(Record):
    """A mesh that was made for a file."""

    path: str  # where the file belongs
    references: tuple[MeshReference, ...]  # that lead there
    defect: str  # what is wrong with the file, such as ``does not exist``
    mesh: Mesh  # in the units of the file: with the scale of its reference it fits the robot
    reason: str  # what it is and why

    def write(self) -> list[str]:
        """Write the file and those that it needs; missing directories are created.

        Returns:
            The paths, that of the mesh first.

        Raises:
            UrdfkitError: it cannot be written.
        """
        return write(self.mesh, self.path)

    def not_written(self, reason: str) -> NotGenerated:
        """The result where the file may not be written."""
        return NotGenerated(self.path, self.references, self.defect, reason)


class NotGenerated(Record):
    """A file for which no mesh can be made, and why."""

    path: str
    references: tuple[MeshReference, ...]
    defect: str
    reason: str


class GeneratedMeshes(Record):
    """What was made for the missing and broken files of a robot, and what was not."""

    generated: tuple[GeneratedMesh, ...]
    not_generated: tuple[NotGenerated, ...]

    @classmethod
    def of(cls, results: Sequence[GeneratedMesh | NotGenerated]) -> GeneratedMeshes:
        made = tuple(one for one in results if isinstance(one, GeneratedMesh))
        return cls(made, tuple(one for one in results if isinstance(one, NotGenerated)))


class NoSuchMesh(UrdfkitError):
    """No shape of the robot names that mesh."""


class NoSuchSize(UrdfkitError):
    """No part can be generated with such edges."""


def generate_missing(robot: Robot) -> GeneratedMeshes:
    """Make a mesh for every file that a robot names and that is missing, empty or broken.

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
    """Make a mesh for one file that a robot names.

    Args:
        reference: as its ``filename`` says.
        part: what to make; chosen by the names if not given.
        size: edges in m, along the axes of the visual or collision; by the link if not given.

    Raises:
        NoSuchMesh: no shape of the robot has this reference.
        NoSuchSize: an edge is out of all bounds.
        SoundMesh: the file is good, and not to be replaced.
    """
    _require_buildable(size)
    references = tuple(mesh for mesh in robot.files.meshes if mesh.at.value == reference)
    if not references:
        from urdfkit.core.suggest import nearest

        known = [mesh.at.value for mesh in robot.files.meshes]
        near = nearest(reference, known)
        hint = f"; did you mean '{near}'?" if near else ""
        raise NoSuchMesh(f"no shape of the robot names '{reference}'{hint}")
    path, defect = _place(references[0])
    if not force:
        require_replaceable(path)
    return _make(robot, path, references, defect or "is to be replaced", part, size)


def generate_part(
    path: str, part: RealPart, size: Vector | None = None, *, force: bool = False
) -> GeneratedMesh:
    """Make a part for a file that no robot names yet.

    Args:
        size: its edges in m, along its own axes; true to life if not given.

    Raises:
        NoSuchSize: an edge is out of all bounds.
        SoundMesh: the file is good, and not to be replaced.
    """
    _require_buildable(size)
    if not force:
        require_replaceable(path)
    facts = sniff_file(path) if disk.exists(path) else None
    defect = facts.defect.reason if facts and facts.defect else "does not exist"
    text = "{:g} x {:g} x {:g} m".format(*(size or part.size))
    return GeneratedMesh(path, (), defect, part.build(size), f"{part.name}, {text}: as asked for")


def _require_buildable(size: Vector | None) -> None:
    """Check that solids can be built in a size.

    Raises:
        NoSuchSize: an edge is out of all bounds.
    """
    if size is not None and not is_buildable(size):
        edges, (least, most) = "{:g} x {:g} x {:g} m".format(*size), BUILDABLE
        raise NoSuchSize(f"{edges}: every edge must be from {least:g} to {most:g} m")


def unusable(robot: Robot) -> Iterator[tuple[str, tuple[MeshReference, ...], str]]:
    """The files that are missing or broken: path, references, and what is wrong."""
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
    """Where the file of a reference belongs, and what is wrong with it; empty if nothing is."""
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
    located = references[0].located
    if located.package is not None and located.directory is None:
        reason = f"package '{located.package}' not found; pass its directory with --package"
        return NotGenerated(path, references, defect, reason)
    if located.scheme not in ("package", "model", "absolute", "relative"):
        return NotGenerated(path, references, defect, f"'{located.scheme}://' leads to no file")
    if not robot.files.resolver.admits(path):
        return NotGenerated(path, references, defect, f"{OUTSIDE}: not written")
    if "Git LFS" in defect:
        return NotGenerated(
            path, references, defect, "run 'git lfs pull', which fetches the mesh itself"
        )
    if os.path.splitext(path)[1].lower() not in SUFFIXES:
        known = ", ".join(SUFFIXES)
        return NotGenerated(path, references, defect, f"only {known} can be written")
    facts = references[0].facts
    if part is None and size is None and facts is not None and facts.defect:
        from urdfkit.mesh.io.salvage import salvage

        left = salvage(path)
        if left is not None and left.share >= _ENOUGH:
            lost = f" ({'; '.join(left.mesh.losses)})" if left.mesh.losses else ""
            reason = f"what is left of it: {left}{lost}"
            return GeneratedMesh(path, references, defect, left.mesh, reason)
    made = placeholder_shape(robot, references[0], part, size)
    if made is None:
        reason = "neither its name nor its link says what it is, or how large"
        return NotGenerated(path, references, defect, reason)
    mesh, why = made
    return GeneratedMesh(path, references, defect, mesh, why)

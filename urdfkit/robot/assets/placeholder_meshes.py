"""Meshes that stand in for files that are missing or broken, made from what the robot tells.

What is left of a broken file is kept where it is most of it. Else the names of file and link tell
a real part (a lidar, a camera, a wheel), and the other shapes of the link its place and size; where
no name does, those shapes themselves are taken. Nothing here guesses without saying so.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.record import Record
from urdfkit.core.spatial import (
    IDENTITY,
    Rotation,
    Transform,
    Vector,
    basis,
    multiply,
    transposed,
    vector,
)
from urdfkit.errors import UrdfkitError
from urdfkit.mesh.io.sniff import sniff_file
from urdfkit.mesh.writers import SUFFIXES, refuse_sound, write
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.assets.target_bounds import (
    BUILDABLE,
    TargetBounds,
    counterparts,
    is_buildable,
    target_bounds,
    turning_axis,
)
from urdfkit.robot.model import Body, Link

if TYPE_CHECKING:
    from urdfkit.mesh.geometry import Mesh, MeshPart
    from urdfkit.mesh.parts import RealPart
    from urdfkit.robot import Robot

#: A broken file is salvaged if this part of its triangles is left.
_ENOUGH = 0.5
#: A part is stretched to its room if no edge needs this many times the factor of another one.
_DISTORTION = 2.0
#: Guessed rooms, out of an inertia tensor, overrule the data sheet up to this factor.
_GUESS = 2.0
#: An axis this near to one of the frame, as a cosine, is meant to be that one.
_ALMOST = 0.999
#: From a sensor that looks along x with z upwards to an optical frame: z forwards, y downwards.
_OPTICAL: Rotation = ((0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0))


class GeneratedMesh(Record):
    """A mesh that was made for a file.

    Attributes:
        path: where the file belongs.
        references: that lead there.
        defect: what is wrong with the file, such as ``does not exist``.
        mesh: in the units of the file: with the scale of its reference it fits the robot.
        reason: what it is and why.
    """

    path: str
    references: tuple[MeshReference, ...]
    defect: str
    mesh: Mesh
    reason: str

    def write(self) -> list[str]:
        """Write the file, and those beside it; missing folders are made.

        Returns:
            The paths, that of the mesh first.

        Raises:
            UrdfkitError: it cannot be written.
        """
        return write(self.mesh, self.path)


class NotGenerated(Record):
    """A file for which no mesh can be made, and why."""

    path: str
    references: tuple[MeshReference, ...]
    defect: str
    reason: str


class GeneratedMeshes(Record):
    """What was made for the missing and broken files of a robot, and what was not."""

    made: tuple[GeneratedMesh, ...]
    undone: tuple[NotGenerated, ...]


class NoSuchMesh(UrdfkitError):
    """No shape of the robot names that mesh."""


class NoSuchSize(UrdfkitError):
    """No part has such edges."""


def generate_missing(robot: Robot) -> GeneratedMeshes:
    """Make a mesh for every file that a robot names and that is missing, empty or broken.

    Nothing is written: see `StandIn.write`.

    Args:
        robot: the robot.
    """
    made: list[GeneratedMesh] = []
    undone: list[NotGenerated] = []
    for path, references, defect in unusable(robot):
        made_here = _make(robot, path, references, defect)
        if isinstance(made_here, GeneratedMesh):
            made.append(made_here)
        else:
            undone.append(made_here)
    return GeneratedMeshes(tuple(made), tuple(undone))


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
        robot: the robot.
        reference: as its ``filename`` says.
        part: what to make; chosen by the names if not given.
        size: edges in m, along the axes of the visual or collision; by the link if not given.
        force: also where the file is a good mesh.

    Raises:
        NoSuchMesh: no shape of the robot has this reference.
        NoSuchSize: an edge is out of all bounds.
        GoodMesh: the file is good, and not to be replaced.
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
        refuse_sound(path)
    return _make(robot, path, references, defect or "is to be replaced", part, size)


def generate_part(
    path: str, part: RealPart, size: Vector | None = None, *, force: bool = False
) -> GeneratedMesh:
    """Make a part for a file that no robot names yet.

    Args:
        path: of the file.
        part: what to make.
        size: its edges in m, along its own axes; true to life if not given.
        force: also where the file is a good mesh.

    Raises:
        NoSuchSize: an edge is out of all bounds.
        GoodMesh: the file is good, and not to be replaced.
    """
    _require_buildable(size)
    if not force:
        refuse_sound(path)
    facts = sniff_file(path) if os.path.exists(path) else None
    defect = facts.defect.reason if facts and facts.defect else "does not exist"
    text = "{:g} x {:g} x {:g} m".format(*(size or part.size))
    return GeneratedMesh(path, (), defect, part.build(size), f"{part.name}, {text}: as asked for")


def _require_buildable(size: Vector | None) -> None:
    """See that solids can be built of a size.

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
    if located.package is not None and located.folder is None:
        reason = f"package '{located.package}' not found; pass its directory with --package"
        return NotGenerated(path, references, defect, reason)
    if located.scheme not in ("package", "model", "absolute", "relative"):
        return NotGenerated(path, references, defect, f"'{located.scheme}://' leads to no file")
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
    made = _generated(robot, references, part, size)
    if made is None:
        reason = "neither its name nor its link tells what it is, or how large"
        return NotGenerated(path, references, defect, reason)
    mesh, why = made
    return GeneratedMesh(path, references, defect, mesh, why)


def _generated(
    robot: Robot,
    references: tuple[MeshReference, ...],
    part: RealPart | None,
    size: Vector | None,
) -> tuple[Mesh, str] | None:
    """A mesh for the first shape that names the file, and what it is; None if nothing tells."""
    from urdfkit.mesh.parts import choose
    from urdfkit.mesh.transforms import scaled

    link, body = _home(robot, references[0])
    here = target_bounds(robot, link, body)
    why = "as asked for"
    if part is None and not _has_mesh(link, body):
        names = {
            "the file": os.path.splitext(os.path.basename(references[0].located.relative))[0],
            "the link": link.name,
        }
        choice = choose(names, size or (here.size if here and here.measured else None))
        if choice is not None:
            part, why = choice
    made: tuple[Mesh, str] | None
    if part is not None:
        made = _part_in_room(robot, link, body, part, size, why)
    elif size is not None:
        made = _block(size, here.frame if here else Transform(), "of the size asked for")
    else:
        made = _copied(robot, link, body)
        if made is None and here is not None:
            made = _block(here.size, here.frame, f"fitted to {here.source} of link '{link.name}'")
    if made is None:
        return None
    assert body.shape is not None
    x, y, z = body.shape.scale
    if x and y and z:
        made = (scaled(made[0], (1 / x, 1 / y, 1 / z)), made[1])
    return made


def _home(robot: Robot, reference: MeshReference) -> tuple[Link, Body]:
    """The link and the shape that hold a reference."""
    for link in robot.model.links:
        for body in (*link.visuals, *link.collisions):
            filename = body.shape.filename if body.shape else None
            if filename is not None and filename.at is reference.at.at:
                return link, body
    raise AssertionError("a reference that no shape has")


def _has_mesh(link: Link, body: Body) -> bool:
    """True if a counterpart of a shape is a mesh: better than any part of our own."""
    others, _ = counterparts(link, body)
    return any(other.shape and other.shape.kind == "mesh" for other in others)


def _part_in_room(
    robot: Robot, link: Link, body: Body, part: RealPart, size: Vector | None, why: str
) -> tuple[Mesh, str]:
    """A real part, turned as the link wants it and fitted to the room there is."""
    from urdfkit.mesh.transforms import moved

    axes = _axes(robot, link, body, part)
    here = target_bounds(robot, link, body, axes)
    if size is not None:
        rows = transposed(axes)
        fitted = vector(sum(abs(a) * b for a, b in zip(row, size, strict=True)) for row in rows)
        how = "of the size asked for"
        frame = here.frame if here else Transform(axes)
    else:
        fitted, how = _fit(part, here, link)
        frame = _seat(part, fitted, here, axes)
    text = "{:g} x {:g} x {:g} m".format(*(round(edge, 6) for edge in fitted))
    assert body.shape is not None
    assert body.shape.filename is not None
    names = (link.name, os.path.basename(body.shape.filename.value))
    return moved(part.build(fitted, names), frame), f"{part.name}, {text}: {why}; {how}"


def _axes(robot: Robot, link: Link, body: Body, part: RealPart) -> Rotation:
    """The axes of a part as columns, in the frame of the shape."""
    if part.turns:
        axis = turning_axis(robot, link, body)
        if axis is None:
            here = target_bounds(robot, link, body)
            if here is None:
                return IDENTITY
            shortest = here.size.index(min(here.size))
            axis = (float(shortest == 0), float(shortest == 1), float(shortest == 2))
        return _with_z_along(axis)
    # A sensor looks along the axes of its link, however the visual is turned in it.
    link_axes = transposed(body.origin.rotation)
    optical = "optical" in link.name.lower() and "camera" in part.kind
    return multiply(link_axes, _OPTICAL) if optical else link_axes


def _with_z_along(axis: Vector) -> Rotation:
    """A rotation whose third column is an axis."""
    for i in range(3):
        if abs(axis[i]) > _ALMOST:
            axis = (float(i == 0), float(i == 1), float(i == 2))
    return transposed(basis(axis))


def _fit(part: RealPart, here: TargetBounds | None, link: Link) -> tuple[Vector, str]:
    """The size that a part gets, and why."""
    if here is None:
        return part.size, "its true size, for the link tells none"
    ratios = [edge / true for edge, true in zip(here.size, part.size, strict=True)]
    where = f"{here.source} of link '{link.name}'"
    if not here.measured and not 1 / _GUESS <= min(ratios) <= max(ratios) <= _GUESS:
        return part.size, f"its true size, for {where} give no likely one"
    if part.turns or max(ratios) <= _DISTORTION * min(ratios):
        return here.size, f"fitted to {where}"
    x, y, z = (min(ratios) * edge for edge in part.size)
    return (x, y, z), f"in its true proportions within {where}"


def _seat(part: RealPart, size: Vector, here: TargetBounds | None, axes: Rotation) -> Transform:
    """Where the middle of a part goes: that of its room; a lower sensor stands on its floor."""
    if here is None:
        return Transform(axes)
    drop = 0.0 if part.turns else (size[2] - here.size[2]) / 2
    return here.frame @ Transform(position=(0.0, 0.0, drop))


def _block(size: Vector, frame: Transform, how: str) -> tuple[Mesh, str]:
    from urdfkit.mesh.parts import block
    from urdfkit.mesh.transforms import moved

    text = "{:g} x {:g} x {:g} m".format(*(round(edge, 6) for edge in size))
    return moved(block.build(size), frame), f"block, {text}: {how}"


def _copied(robot: Robot, link: Link, body: Body) -> tuple[Mesh, str] | None:
    """The other shapes of the link as one mesh; None if there are none, or one is not known."""
    from urdfkit.mesh.geometry import Mesh
    from urdfkit.mesh.transforms import moved
    from urdfkit.robot.assets.geometry import body_mesh

    others, source = counterparts(link, body)
    parts: list[MeshPart] = []
    for other in others:
        mesh = body_mesh(robot, other)
        if mesh is None:
            return None
        parts += moved(mesh, body.origin.inverse @ other.origin).parts
    if not parts:
        return None
    return Mesh(tuple(parts), up_axis="Z_UP"), f"the shape of {source} of link '{link.name}'"

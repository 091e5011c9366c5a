"""The shape of a placeholder mesh: a real part, a copy of other shapes, or a block."""

import os

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
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.parts import RealPart
from urdfkit.robot import Robot
from urdfkit.robot.assets.geometry import body_mesh
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.assets.target_bounds import (
    TargetBounds,
    counterparts,
    target_bounds,
    turning_axis,
)
from urdfkit.robot.model import Body, Link

#: A part is stretched to its bounds if no edge needs this many times the factor of another one.
_DISTORTION = 2.0
#: Target bounds guessed from an inertia tensor overrule the data sheet up to this factor.
_GUESS = 2.0
#: An axis this near to one of the frame, as a cosine, is taken for that one.
_ALMOST = 0.999
#: From a sensor that looks along x with z upwards to an optical frame: z forwards, y downwards.
_OPTICAL: Rotation = ((0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0))


def placeholder_shape(
    robot: Robot, reference: MeshReference, part: RealPart | None, size: Vector | None
) -> tuple[Mesh, str] | None:
    """A mesh for a shape, in the units of its file, and what it is; None if nothing says.

    Args:
        part: what to make; chosen by the names if not given.
        size: edges in m, along the axes of the visual or collision; by the link if not given.
    """
    from urdfkit.mesh.parts import choose
    from urdfkit.mesh.transforms import scaled

    link, body = reference.link, reference.body
    here = target_bounds(robot, link, body)
    why = "as asked for"
    if part is None and not _has_mesh(link, body):
        names = {
            "the file": os.path.splitext(os.path.basename(reference.located.relative))[0],
            "the link": link.name,
        }
        choice = choose(names, size or (here.size if here and here.measured else None))
        if choice is not None:
            part, why = choice
    made: tuple[Mesh, str] | None
    if part is not None:
        made = _fitted_part(robot, link, body, part, size, why)
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


def _has_mesh(link: Link, body: Body) -> bool:
    """True if a counterpart of a shape is a mesh: better than any part of our own."""
    others, _ = counterparts(link, body)
    return any(other.shape and other.shape.kind == "mesh" for other in others)


def _fitted_part(
    robot: Robot, link: Link, body: Body, part: RealPart, size: Vector | None, why: str
) -> tuple[Mesh, str]:
    """A real part, rotated to the axes of the link and fitted to the target bounds."""
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
        return part.size, "its true size, for the link has none"
    ratios = [edge / true for edge, true in zip(here.size, part.size, strict=True)]
    where = f"{here.source} of link '{link.name}'"
    if not here.measured and not 1 / _GUESS <= min(ratios) <= max(ratios) <= _GUESS:
        return part.size, f"its true size, for {where} give no likely one"
    if part.turns or max(ratios) <= _DISTORTION * min(ratios):
        return here.size, f"fitted to {where}"
    x, y, z = (min(ratios) * edge for edge in part.size)
    return (x, y, z), f"in its true proportions within {where}"


def _seat(part: RealPart, size: Vector, here: TargetBounds | None, axes: Rotation) -> Transform:
    """The frame of a part: the middle of its bounds; a lower sensor stands on their floor."""
    if here is None:
        return Transform(axes)
    drop = 0.0 if part.turns else (size[2] - here.size[2]) / 2
    return here.frame @ Transform(position=(0.0, 0.0, drop))


def _block(size: Vector, frame: Transform, how: str) -> tuple[Mesh, str]:
    from urdfkit.mesh.parts.building import block
    from urdfkit.mesh.transforms import moved

    text = "{:g} x {:g} x {:g} m".format(*(round(edge, 6) for edge in size))
    return moved(block(size), frame), f"block, {text}: {how}"


def _copied(robot: Robot, link: Link, body: Body) -> tuple[Mesh, str] | None:
    """The other shapes of the link as one mesh; None if there are none, or one is not known."""
    from urdfkit.mesh.geometry import Mesh
    from urdfkit.mesh.transforms import moved

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

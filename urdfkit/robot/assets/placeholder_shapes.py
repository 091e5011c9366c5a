"""Shapes of placeholder meshes: a real part, a copy of other shapes, or a block."""

import os

from urdfkit.core.spatial import (
    AXES,
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
from urdfkit.robot.link import Body, Link

#: A part is stretched to its bounds if the factors of its edges differ by this ratio at most.
_DISTORTION = 2.0
#: Target bounds guessed from an inertia tensor overrule the data sheet up to this ratio.
_MAX_GUESS = 2.0
#: An axis with a larger cosine to an axis of the frame is replaced by that axis.
_MIN_COSINE = 0.999
#: Rotation from a sensor frame (x forwards, z up) to an optical frame (z forwards, y down).
_OPTICAL: Rotation = ((0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0))


def placeholder_shape(
    robot: Robot, reference: MeshReference, part: RealPart | None, size: Vector | None
) -> tuple[Mesh, str] | None:
    """A mesh for a shape in the units of its file, and its description; None if unknown.

    Args:
        part: the part to generate; chosen by the names if None.
        size: edges in m, along the axes of the visual or collision; derived from the link if None.
    """
    from urdfkit.mesh.parts import choose
    from urdfkit.mesh.transforms import scaled

    link, body = reference.link, reference.body
    bounds = target_bounds(robot, link, body)
    why = "as requested"
    if part is None and not _has_mesh(link, body):
        names = {
            "the file": os.path.splitext(os.path.basename(reference.located.relative))[0],
            "the link": link.name,
        }
        choice = choose(names, size or (bounds.size if bounds and bounds.measured else None))
        if choice is not None:
            part, why = choice
    result: tuple[Mesh, str] | None
    if part is not None:
        result = _fitted_part(robot, link, body, part, size, why)
    elif size is not None:
        result = _block(size, bounds.frame if bounds else Transform(), "of the requested size")
    else:
        result = _copied(robot, link, body)
        if result is None and bounds is not None:
            reason = f"fitted to {bounds.source} of link '{link.name}'"
            result = _block(bounds.size, bounds.frame, reason)
    if result is None:
        return None
    assert body.shape is not None
    x, y, z = body.shape.scale
    if x and y and z:
        result = (scaled(result[0], (1 / x, 1 / y, 1 / z)), result[1])
    return result


def _has_mesh(link: Link, body: Body) -> bool:
    """True if a counterpart of a shape is a mesh, which is preferred to a generated part."""
    bodies, _ = counterparts(link, body)
    return any(counterpart.is_mesh for counterpart in bodies)


def _fitted_part(
    robot: Robot, link: Link, body: Body, part: RealPart, size: Vector | None, why: str
) -> tuple[Mesh, str]:
    """A real part, rotated to the axes of the link and fitted to the target bounds."""
    from urdfkit.mesh.transforms import moved

    axes = _axes(robot, link, body, part)
    bounds = target_bounds(robot, link, body, axes)
    if size is not None:
        rows = transposed(axes)
        fitted = vector(sum(abs(a) * b for a, b in zip(row, size, strict=True)) for row in rows)
        reason = "of the requested size"
        frame = bounds.frame if bounds else Transform(axes)
    else:
        fitted, reason = _fit(part, bounds, link)
        frame = _seat(part, fitted, bounds, axes)
    assert body.shape is not None
    assert body.shape.filename is not None
    names = (link.name, os.path.basename(body.shape.filename.value))
    return moved(
        part.build(fitted, names), frame
    ), f"{part.name}, {_edges(fitted)}: {why}; {reason}"


def _axes(robot: Robot, link: Link, body: Body, part: RealPart) -> Rotation:
    """The axes of a part as columns, in the frame of the shape."""
    if part.turns:
        axis = turning_axis(robot, link, body)
        if axis is None:
            bounds = target_bounds(robot, link, body)
            if bounds is None:
                return IDENTITY
            shortest = bounds.size.index(min(bounds.size))
            axis = AXES[shortest]
        return _with_z_along(axis)
    # A sensor is aligned with its link, whatever the rotation of the visual.
    link_axes = transposed(body.origin.rotation)
    optical = "optical" in link.name.lower() and "camera" in part.kind
    return multiply(link_axes, _OPTICAL) if optical else link_axes


def _with_z_along(axis: Vector) -> Rotation:
    """A rotation whose third column is an axis."""
    for i in range(3):
        if abs(axis[i]) > _MIN_COSINE:
            axis = AXES[i]
    return transposed(basis(axis))


def _fit(part: RealPart, bounds: TargetBounds | None, link: Link) -> tuple[Vector, str]:
    """The size of a generated part, and the reason."""
    if bounds is None:
        return part.size, "its true size: the link has no size"
    ratios = [edge / true for edge, true in zip(bounds.size, part.size, strict=True)]
    where = f"{bounds.source} of link '{link.name}'"
    if not bounds.measured and not 1 / _MAX_GUESS <= min(ratios) <= max(ratios) <= _MAX_GUESS:
        return part.size, f"its true size: {where} give no plausible size"
    if part.turns or max(ratios) <= _DISTORTION * min(ratios):
        return bounds.size, f"fitted to {where}"
    x, y, z = (min(ratios) * edge for edge in part.size)
    return (x, y, z), f"in its true proportions within {where}"


def _seat(part: RealPart, size: Vector, bounds: TargetBounds | None, axes: Rotation) -> Transform:
    """The frame of a part in the middle of its bounds; a lower sensor stands on their floor."""
    if bounds is None:
        return Transform(axes)
    drop = 0.0 if part.turns else (size[2] - bounds.size[2]) / 2
    return bounds.frame @ Transform(position=(0.0, 0.0, drop))


def _block(size: Vector, frame: Transform, how: str) -> tuple[Mesh, str]:
    from urdfkit.mesh.parts.building import block
    from urdfkit.mesh.transforms import moved

    return moved(block(size), frame), f"block, {_edges(size)}: {how}"


def _edges(size: Vector) -> str:
    """A size in m as text, such as ``0.1 x 0.2 x 0.3 m``."""
    return "{:g} x {:g} x {:g} m".format(*(round(edge, 6) for edge in size))


def _copied(robot: Robot, link: Link, body: Body) -> tuple[Mesh, str] | None:
    """The counterparts of a shape as one mesh; None without any, or if one cannot be loaded."""
    from urdfkit.mesh.transforms import moved

    bodies, source = counterparts(link, body)
    parts: list[MeshPart] = []
    for counterpart in bodies:
        mesh = body_mesh(robot, counterpart)
        if mesh is None:
            return None
        parts += moved(mesh, body.origin.inverse @ counterpart.origin).parts
    if not parts:
        return None
    return Mesh(tuple(parts), up_axis="Z_UP"), f"the shape of {source} of link '{link.name}'"

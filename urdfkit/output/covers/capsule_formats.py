"""Capsules as collisions in URDF."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist
from typing import TYPE_CHECKING
from xml.etree.ElementTree import Element

from urdfkit.core.spatial import IDENTITY, Transform, Vector, basis, transposed, vector
from urdfkit.lint.context import Context
from urdfkit.output.covers import LinkCover, RobotCover
from urdfkit.output.covers.urdf import DECIMALS, collision, replaced

if TYPE_CHECKING:
    from collections.abc import Callable

#: A shorter capsule, in m, is a sphere.
_MIN_LENGTH = 10.0**-DECIMALS


def urdf(robot: Context, found: RobotCover) -> str:
    """The robot without xacro, with a ``<capsule>`` of URDF 1.1 for each capsule."""
    return _with(robot, found, _capsule)


def urdf_1_0(robot: Context, found: RobotCover) -> str:
    """The robot without xacro, with a cylinder and two spheres for each capsule."""
    return _with(robot, found, _cylinder_and_spheres)


#: The function of each format, by its name.
FORMATS = {"urdf": urdf, "urdf-1.0": urdf_1_0}


def _with(
    robot: Context, found: RobotCover, shapes: Callable[[Vector, Vector, float], Iterator[Element]]
) -> str:
    return replaced(
        robot,
        {
            cover.link: [shape for ends in _capsules(cover) for shape in shapes(*ends)]
            for cover in found.links
        },
    )


def _capsules(cover: LinkCover) -> Iterator[tuple[Vector, Vector, float]]:
    """The ends of each axis, and the radius."""
    shapes = cover.shapes._asdict()
    for (start, end), radius in zip(shapes["segments"], shapes["radii"], strict=True):
        yield vector(start), vector(end), float(radius)


def _capsule(start: Vector, end: Vector, radius: float) -> Iterator[Element]:
    if dist(start, end) < _MIN_LENGTH:
        yield _sphere(start, radius)
    else:
        yield _along("capsule", start, end, radius)


def _cylinder_and_spheres(start: Vector, end: Vector, radius: float) -> Iterator[Element]:
    yield _sphere(start, radius)
    if dist(start, end) >= _MIN_LENGTH:
        yield _along("cylinder", start, end, radius)
        yield _sphere(end, radius)


def _sphere(center: Vector, radius: float) -> Element:
    return collision("sphere", Transform(IDENTITY, center), radius=radius)


def _along(tag: str, start: Vector, end: Vector, radius: float) -> Element:
    """A capsule or cylinder, whose axis is z of its frame."""
    length = dist(start, end)
    along = vector([(b - a) / length for a, b in zip(start, end, strict=True)])
    middle = vector([(a + b) / 2 for a, b in zip(start, end, strict=True)])
    frame = Transform(transposed(basis(along)), middle)
    return collision(tag, frame, radius=radius, length=length)

"""Centres of mass and products of inertia with the wrong sign, next to their mirror image."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, rotate, vector
from urdfkit.robot.inertia import rotated
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import Masses
from urdfkit.robot.link import Tensor
from urdfkit.robot.symmetry import have_same_meshes
from urdfkit.text.document import Element

#: Tolerance of the positions of mirrored links, in m.
_MAX_OFFSET = 1e-3
#: Part of the largest moment that a product of inertia differs by at most, and must have to count.
_TOLERANCE, _LEAST_PRODUCT = 0.02, 0.04
#: Part of a product that it differs by at most.
_PRODUCT_TOLERANCE = 0.1
#: The same for a coordinate of a centre of mass, in m.
_MAX_DISTANCE, _LEAST_COORDINATE = 2e-3, 5e-3

_PRODUCTS, _AXES = ("ixy", "ixz", "iyz"), ("x", "y", "z")
_ALL = frozenset((*_PRODUCTS, *_AXES))
#: What a mirror image has with the other sign.
_TURNED = frozenset(("ixy", "iyz", "y"))


class WrongSign(Record):
    """A link that would be the mirror image of its counterpart with another sign."""

    left: LinkInertia
    right: LinkInertia
    what: str  # a product of inertia, or a coordinate of the centre of mass
    value: float  # of it, in kg·m² or m, with the wrong sign
    at: Element  # of the right link


def wrong_signs(masses: Masses) -> Iterator[WrongSign]:
    """The places with a wrong sign, if each is the only one of its kind in a robot."""
    mirrored = [pair for pair in masses.symmetric_pairs if _are_mirrored(masses, *pair)]
    for find in (_product, _center):
        found: list[WrongSign] = []
        consistent: list[frozenset[str]] = []
        for left, right in mirrored:
            frames = masses.tree.frames[left.name], masses.tree.frames[right.name]
            result = find(left, right, *frames)
            if isinstance(result, WrongSign):
                found.append(result)
            else:
                consistent.append(result)
        places = {element.at.tag_at for element in found}
        # Where nothing is turned over, tensors and centres are copies, not mirror images.
        kind = _TURNED if found and found[0].what in _TURNED else _ALL
        if len(places) == 1 and sum(map(bool, map(kind.intersection, consistent))) > 1:
            yield found[0]


def _are_mirrored(masses: Masses, left: LinkInertia, right: LinkInertia) -> bool:
    if have_same_meshes(left.link, right.link):
        return False
    one, other = (masses.tree.frames.get(link.name) for link in (left, right))
    if one is None or other is None:
        return False
    (x, y, z), (a, b, c) = one.position, other.position
    return max(abs(x - a), abs(y + b), abs(z - c)) <= _MAX_OFFSET


def _product(
    left: LinkInertia, right: LinkInertia, frame: Transform, other: Transform
) -> WrongSign | frozenset[str]:
    """A product with the wrong sign; else the large products of mirror images."""
    image = _image(_in_root(left, left.tensor, frame))
    allowed = _TOLERANCE * left.moments[2]
    count = _LEAST_PRODUCT * left.moments[2]

    def is_image(tensor: Tensor) -> bool:
        return _is_near(_in_root(right, tensor, other), image, allowed)

    if is_image(right.tensor):
        return frozenset(name for name in _PRODUCTS if abs(getattr(image, name)) > count)
    for name in _PRODUCTS:
        value = getattr(right.tensor, name)
        turned = right.tensor._replace(**{name: -value})
        expected = getattr(_in_root(right, turned, other), name)
        is_alike = abs(expected - getattr(image, name)) <= _PRODUCT_TOLERANCE * abs(value)
        if abs(value) > count and is_alike and is_image(turned):
            return WrongSign(left, right, name, value, right.at)
    return frozenset()


def _in_root(link: LinkInertia, tensor: Tensor, frame: Transform) -> Tensor:
    return rotated(rotated(tensor, link.inertial.origin.rotation), frame.rotation)


def _image(tensor: Tensor) -> Tensor:
    """The mirror image of a tensor in the plane y = 0."""
    return tensor._replace(ixy=-tensor.ixy, iyz=-tensor.iyz)


def _center(
    left: LinkInertia, right: LinkInertia, frame: Transform, other: Transform
) -> WrongSign | frozenset[str]:
    """A coordinate with the wrong sign; else the large coordinates of mirror images."""
    x, y, z = rotate(frame.rotation, left.inertial.origin.position)
    center = right.inertial.origin.position
    image = (x, -y, z)

    def is_image(place: Vector) -> bool:
        return _is_near(rotate(other.rotation, place), image, _MAX_DISTANCE)

    if is_image(center):
        return frozenset(
            axis for axis, c in zip(_AXES, image, strict=True) if abs(c) > _LEAST_COORDINATE
        )
    for axis, value in zip(_AXES, center, strict=True):
        turned = vector(-c if name == axis else c for name, c in zip(_AXES, center, strict=True))
        if abs(value) > _LEAST_COORDINATE and is_image(turned):
            at = right.inertial.at.child_or_self("origin")
            return WrongSign(left, right, axis, value, at)
    return frozenset()


def _is_near(one: Iterable[float], other: Iterable[float], allowed: float) -> bool:
    return all(abs(a - b) <= allowed for a, b in zip(one, other, strict=True))

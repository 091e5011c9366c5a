"""A link and its left/right counterpart differ in mass, inertia or centre of mass.

Mirror images have the same mass and the same principal moments. If one side has clearly more, a
decimal point is misplaced, or only one side was edited; also if one pair of five or more is the
only one that differs, by 5 % or more. The robot pulls to one side, and a
controller tuned for one hand oscillates with the other. Compare the two, and give both the right
value.

The mass of a link of one finger is reported if it is a fifth or five times that of the same link of
all others, three or more.

In the plane y = 0 of the root, the mirror image of a link has the y of its centre of mass, ixy and
iyz with the other sign. One that would be the mirror image of its counterpart with another sign is
reported if all other pairs are mirror images: of two tensors, the one that others with its mesh do
not have; of two centres of mass, the one that is outside the shapes. Weights that balance the robot
may differ.

Sources:
    robotology/icub-models#269: https://github.com/robotology/icub-models/issues/269
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import partial

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, rotate, vector
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.fingers import odd_one, series
from urdfkit.robot.inertia import principal_moments, rotated
from urdfkit.robot.inertials.defects import distance_outside
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import ONLY_PAIR, Masses, unlike
from urdfkit.robot.inertials.tensor_text import format_moments
from urdfkit.robot.link import Tensor
from urdfkit.robot.samples import hand_xml, inertial_xml
from urdfkit.robot.shapes import LinkSolid
from urdfkit.robot.symmetry import are_copies
from urdfkit.text.document import Element

_ORIGINS = ['<origin xyz="0 0.02 0"/>'], ['<origin xyz="0 -0.02 0"/>']
GOOD = hand_xml("fixed", *_ORIGINS, inertial_xml("0.015", "2.4e-6 2.4e-6 7.5e-7"))
BAD = '"0.15"'.join(GOOD.rsplit('"0.015"', 1))
#: Words in the names of weights that balance a robot.
_BALANCES = r"(?i)ballast|counter_?weight|trim"

#: Tolerance of the positions of mirrored links, in m.
_MAX_OFFSET = 1e-3
#: Part of the largest moment that a product of inertia differs by at most, and must have to count.
_TOLERANCE, _LEAST_PRODUCT = 0.02, 0.025
#: Part of a product that it differs by at most.
_PRODUCT_TOLERANCE = 0.1
#: The same for a coordinate of a centre of mass, in m.
_MAX_DISTANCE, _LEAST_COORDINATE = 2e-3, 5e-3
#: Parts of the size and of the largest moment by which two copies of a mesh differ at most.
_SAME = 1e-3

#: Ratio of the mass of a link to that of the same link of all other fingers.
_MAX_RATIO = 5.0

_PRODUCTS, _AXES = ("ixy", "ixz", "iyz"), ("x", "y", "z")
_ALL = frozenset((*_PRODUCTS, *_AXES))
#: What a mirror image has with the other sign.
_TURNED = frozenset(("ixy", "iyz", "y"))


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="compare the two, and give both the right value",
)
def check(context: Context) -> Findings:
    for left, right in context.masses.asymmetric_pairs:
        is_clear = unlike(left, right)
        reason = "" if is_clear else "; all other counterparts are alike"
        if (is_clear or unlike(left, right, ONLY_PAIR, ONLY_PAIR)) != "mass":
            yield _of_inertia(left, right, reason)
        elif not re.search(_BALANCES, left.link.name):
            yield _of_mass(left, right, reason)
    for wrong in _wrong_signs(context.masses):
        yield _of_sign(wrong)
    yield from _odd_fingers(context.masses)


def _odd_fingers(masses: Masses) -> Findings:
    """The link of one finger whose mass is far from that of the same link of all others."""
    for names in series(masses.by_name):
        odd = odd_one({name: masses.by_name[name].mass for name in names})
        link = masses.by_name[odd[0]] if odd else None
        if odd is None or link is None or link.inertial.mass is None:
            continue
        ratio = link.mass / odd[1]
        if not 1 / _MAX_RATIO < ratio < _MAX_RATIO:
            other = next(masses.by_name[name] for name in names if name != odd[0])
            yield Finding(
                link.inertial.mass,
                f"link '{link.name}' has {link.mass:g} kg, the same link of all other fingers "
                f"{odd[1]:g} kg",
                f"write {odd[1]:g}",
                related=(Related(other.at.span, f"the inertia of '{other.name}'"),),
            )


def _of_mass(left: LinkInertia, right: LinkInertia, reason: str) -> Finding:
    assert left.inertial.mass is not None
    assert right.inertial.mass is not None
    ratio = max(left.mass, right.mass) / min(left.mass, right.mass)
    return Finding(
        right.inertial.mass,
        f"link '{right.link.name}' has {right.mass:g} kg, its counterpart '{left.link.name}' "
        f"{left.mass:g} kg: a factor of {ratio:.3g}{reason}",
        related=(Related(left.inertial.mass.span, f"'{left.link.name}' has {left.mass:g} kg"),),
        weight=ratio,
    )


def _of_inertia(left: LinkInertia, right: LinkInertia, reason: str) -> Finding:
    equal = "the same" if left.mass == right.mass else "nearly the same"
    return Finding(
        right.at,
        f"link '{right.link.name}' has principal moments of inertia of "
        f"{format_moments(right.moments)}, its counterpart '{left.link.name}' of {equal} mass "
        f"{format_moments(left.moments)}{reason}",
        related=(Related(left.at.span, f"the inertia of '{left.link.name}'"),),
    )


def _of_sign(wrong: _WrongSign) -> Finding:
    is_product = wrong.what.startswith("i")
    name = wrong.what if is_product else f"{wrong.what} of the centre of mass"
    unit = "kg·m²" if is_product else "m"
    return Finding(
        wrong.at,
        f"link '{wrong.right.name}': {name} is {wrong.value:g} {unit}; with the other sign the "
        f"link would be the mirror image of its counterpart '{wrong.left.name}', as others are",
        f"write {-wrong.value:g}, or correct the counterpart",
        related=(Related(wrong.left.at.span, f"the inertia of '{wrong.left.name}'"),),
    )


class _WrongSign(Record):
    """A link that would be the mirror image of its counterpart with another sign."""

    left: LinkInertia
    right: LinkInertia
    what: str  # a product of inertia, or a coordinate of the centre of mass
    value: float  # of it, in kg·m² or m, with the wrong sign
    at: Element  # of the right link


def _wrong_signs(masses: Masses) -> Iterator[_WrongSign]:
    """The places with a wrong sign, if each is the only one of its kind in a robot."""
    mirrored = [pair for pair in masses.symmetric_pairs if _are_mirrored(masses, *pair)]
    # Of two counterparts, the one whose centre is outside of its shapes is wrong.
    by_part = [sorted(pair, key=partial(_is_unlike_its_part, masses)) for pair in mirrored]
    ordered = [sorted(pair, key=distance_outside) for pair in by_part]
    for find in (_product, _center):
        found: list[_WrongSign] = []
        consistent: list[frozenset[str]] = []
        for left, right in ordered:
            frames = masses.tree.frames[left.name], masses.tree.frames[right.name]
            result = find(left, right, *frames)
            if not isinstance(result, _WrongSign):
                consistent.append(result)
            elif not _have_same_meshes(left, right):
                found.append(result)
        places = {element.at.tag_at for element in found}
        # Where nothing is turned over, tensors and centres are copies, not mirror images.
        kind = _TURNED if found and found[0].what in _TURNED else _ALL
        if len(places) == 1 and sum(map(bool, map(kind.intersection, consistent))) > 1:
            yield found[0]


def _is_unlike_its_part(masses: Masses, link: LinkInertia) -> bool:
    """True if other links have the meshes of this one, and none of them has its tensor."""
    meshes = _meshes(link)
    others = (one for one in masses.by_name.values() if one is not link)
    same = [one.tensor for one in others if _meshes(one) == meshes] if meshes else []
    allowed = _TOLERANCE * link.moments[2]
    return bool(same) and not any(_is_near(tensor, link.tensor, allowed) for tensor in same)


def _meshes(link: LinkInertia) -> list[str]:
    return [body.file.value for body in link.link.visuals if body.file]


def _are_mirrored(masses: Masses, left: LinkInertia, right: LinkInertia) -> bool:
    if are_copies(left.link, right.link):
        return False
    one, other = (masses.tree.frames.get(link.name) for link in (left, right))
    if one is None or other is None:
        return False
    (x, y, z), (a, b, c) = one.position, other.position
    return max(abs(x - a), abs(y + b), abs(z - c)) <= _MAX_OFFSET


def _have_same_meshes(one: LinkInertia, other: LinkInertia) -> bool:
    """True for meshes that are alike in the frames of both links, though their files differ."""
    if not (one.link.visuals and all(body.file for body in one.link.visuals)):
        return False
    if not one.solids or len(one.solids) != len(other.solids):
        return False
    return all(map(_are_alike, one.solids, other.solids))


def _are_alike(one: LinkSolid, other: LinkSolid) -> bool:
    """True for two solids of the same size, place and distribution of mass."""
    a, b = one.properties(1.0), other.properties(1.0)
    allowed = _SAME * max(one.bounds.edges)
    return (
        _is_near(one.bounds.low, other.bounds.low, allowed)
        and _is_near(one.bounds.high, other.bounds.high, allowed)
        and _is_near(a.center, b.center, allowed)
        and _is_near(a.tensor, b.tensor, _SAME * principal_moments(a.tensor)[2])
    )


def _product(
    left: LinkInertia, right: LinkInertia, frame: Transform, other: Transform
) -> _WrongSign | frozenset[str]:
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
            return _WrongSign(left, right, name, value, right.at)
    return frozenset()


def _in_root(link: LinkInertia, tensor: Tensor, frame: Transform) -> Tensor:
    return rotated(rotated(tensor, link.inertial.origin.rotation), frame.rotation)


def _image(tensor: Tensor) -> Tensor:
    """The mirror image of a tensor in the plane y = 0."""
    return tensor._replace(ixy=-tensor.ixy, iyz=-tensor.iyz)


def _center(
    left: LinkInertia, right: LinkInertia, frame: Transform, other: Transform
) -> _WrongSign | frozenset[str]:
    """A coordinate with the wrong sign; else the large coordinates of mirror images."""
    x, y, z = rotate(frame.rotation, left.inertial.origin.position)
    center = right.inertial.origin.position
    image = (x, -y, z)

    def is_image(place: Vector) -> bool:
        # Small coordinates often differ: the two are copies turned about an axis.
        return all(
            abs(a - b) <= _MAX_DISTANCE or max(abs(a), abs(b)) <= _LEAST_COORDINATE
            for a, b in zip(rotate(other.rotation, place), image, strict=True)
        )

    if is_image(center):
        return frozenset(
            axis for axis, c in zip(_AXES, image, strict=True) if abs(c) > _LEAST_COORDINATE
        )
    for axis, value in zip(_AXES, center, strict=True):
        turned = vector(-c if name == axis else c for name, c in zip(_AXES, center, strict=True))
        if abs(value) > _LEAST_COORDINATE and is_image(turned):
            at = right.inertial.at.child_or_self("origin")
            return _WrongSign(left, right, axis, value, at)
    return frozenset()


def _is_near(one: Iterable[float], other: Iterable[float], allowed: float) -> bool:
    return all(abs(a - b) <= allowed for a, b in zip(one, other, strict=True))

"""The defects of masses and inertia tensors; of a tensor, the one that explains it best."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from enum import Enum
from math import dist

from urdfkit.core.spatial import ORIGIN, Vector
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot.inertia import principal_moments, scaled
from urdfkit.robot.inertials.link_comparison import (
    LARGEST_PART,
    SIGNIFICANT,
    LinkInertia,
    by_tensor,
)
from urdfkit.robot.rigid_bodies import RigidBody
from urdfkit.robot.shapes import BoundingBox, MeshSolid, Primitive

if TYPE_CHECKING:
    Matters = Callable[[RigidBody, float], bool]

#: Times the largest possible moment from which on it is reported: a link may be somewhat larger
#: than its collision shape.
TOO_LARGE = 2.0

#: Part of the uniform solid's moment below which no mass in the middle explains it.
TOO_SMALL = 0.01

#: Densities of robot parts in kg/m³, from hollow plastic to lead.
LIGHTEST, HEAVIEST = 20.0, 12000.0
#: Lengths that differ by more are those of shapes in different units.
SCALED = 500.0
#: A centre of mass may be this far in m from a shape that only marks a place.
FAR_FROM_MARKER = 0.1

#: A density outside by less than this factor may be that of a shape drawn a little too small.
NEAR = 1.2

#: Densities of most of them; a mistake in the unit must lead to one of these.
USUAL = (100.0, 8000.0)

#: A centre of mass outside the shapes by this part of their length, where a mistake explains it;
#: and where it was left at zero, as on many links.
MISTAKEN, LEFT_AT_ORIGIN = 0.15, 0.5

#: Part of its rigid body's mass from which on the centre of a link matters.
NOTICEABLE = 0.1

#: A radius of gyration over this, in m, is larger than most robots; and so many links with equal
#: tensors were not measured.
WIDE, MANY = 0.3, 3


class InertiaDefect(Enum):
    """What is wrong with the inertial of a link."""

    INDEFINITE = "indefinite"
    TRIANGLE_INEQUALITY = "triangle inequality"
    TOO_LARGE = "too large"
    TOO_SMALL = "too small"
    WRONG_AXES = "wrong axes"
    UNLIKE_SHAPE = "unlike shape"
    PLACEHOLDER = "placeholder"
    DENSITY = "density"
    CENTER_OF_MASS = "center of mass"


def find_defects(
    inertias: Iterable[LinkInertia], matters: Matters, by_macro: Collection[str]
) -> dict[InertiaDefect, list[LinkInertia]]:
    """The links with each defect.

    Args:
        matters: True for a moment in kg·m² that is a noticeable part of a rigid body's.
        by_macro: names of links whose tensor a macro gives to links of different mass.
    """
    found: dict[InertiaDefect, list[LinkInertia]] = {}
    placeholders: list[LinkInertia] = []
    for one in inertias:
        if defect := _defect(one, matters):
            found.setdefault(defect, []).append(one)
        elif one.is_placeholder and not one.is_measured:
            placeholders.append(one)
        elif _is_unlike_shape(one):
            found.setdefault(InertiaDefect.UNLIKE_SHAPE, []).append(one)
        if center_is_outside(one) and one.mass >= SIGNIFICANT * one.body.mass:
            found.setdefault(InertiaDefect.CENTER_OF_MASS, []).append(one)
    _sort_placeholders(placeholders, matters, by_macro, found)
    return found


def _defect(one: LinkInertia, matters: Matters) -> InertiaDefect | None:
    """What makes a tensor or a mass impossible or implausible; None if nothing does."""
    if one.is_indefinite:
        return InertiaDefect.INDEFINITE
    if one.breaks_triangle:
        return InertiaDefect.TRIANGLE_INEQUALITY
    if one.is_noise or not one.is_measured or one.body.is_ground:
        return None
    if _is_of_unknown_size(one):
        return None
    implausible = implausible_density(one) is not None
    if implausible and unit_mistake(one):
        return InertiaDefect.DENSITY
    assert one.expected is not None
    high, expected = one.moments[2], principal_moments(one.expected)[2]
    if high > TOO_LARGE * one.largest_possible and matters(one.body, high):
        return InertiaDefect.TOO_LARGE
    if high < TOO_SMALL * expected and matters(one.body, expected):
        return InertiaDefect.TOO_SMALL
    if implausible:
        return InertiaDefect.DENSITY
    if one.is_at_wrong_axes and matters(one.body, high):
        return InertiaDefect.WRONG_AXES
    return None


def _is_of_unknown_size(one: LinkInertia) -> bool:
    """True if the shapes mark a place, or are in metres and in millimetres."""
    return _is_in_two_units(one) or (one.is_marker and one.radius_of_gyration < WIDE)


def _is_in_two_units(one: LinkInertia) -> bool:
    """True if one shape is in metres, another in millimetres (MSH012, GEO004)."""
    lengths = [max(part.longest for part in solid.parts) for solid in one.solids]
    return max(lengths) > SCALED * min(lengths)


def implausible_density(link: LinkInertia) -> float | None:
    """The density in kg/m³ if no material of robots has it; the one nearer to a material's."""
    if link.densities is None or link.mass < SIGNIFICANT * link.body.mass:
        return None
    low, high = link.densities
    if low > HEAVIEST * NEAR:
        return low
    return high if high < LIGHTEST / NEAR else None


def unit_mistake(link: LinkInertia) -> str:
    """The unit that explains an implausible density: ``g``, ``mm``, or nothing."""
    if link.densities is None or link.solid is None or link.expected is None:
        return ""
    low, high = link.densities
    if low > HEAVIEST and USUAL[0] <= low / 1000 <= USUAL[1]:
        consistent = link.fits(link.expected, 3)
        return "g" if consistent or link.fits(scaled(link.expected, 1e-3), 3) else ""
    plausible = USUAL[0] <= high * 1e9 <= USUAL[1]
    return "mm" if plausible and max(link.solid.bounds.edges) > LARGEST_PART else ""


def center_is_outside(link: LinkInertia) -> float | None:
    """How far the centre of mass is outside the shapes, in m, if that is probably a mistake.

    More than their size; or less, where a mistake explains it.
    """
    if not link.is_measured or link.solid is None or link.body.is_ground:
        return None
    center = link.inertial.origin.position
    # A box around a part is at least its length by the root of 3 long, and holds its middle.
    if any(2 * dist(center, part.origin.position) <= part.longest for part in link.solid.parts):
        return None
    distance, longest = _outside(center, link.outline), max(link.outline.edges)
    if link.is_marker and distance < FAR_FROM_MARKER:
        return None
    if distance > longest or (distance > MISTAKEN * longest and not link.is_marker):
        return distance if distance > longest or center_mistake(link) else None
    return None


def center_mistake(link: LinkInertia) -> str:
    """What explains that the centre of mass is outside: a predicate whose subject is the centre."""
    center, outline = link.inertial.origin.position, link.outline
    if center == ORIGIN:
        far = _outside(center, outline) > LEFT_AT_ORIGIN * max(outline.edges)
        matters = link.mass > NOTICEABLE * link.body.mass
        return "was left at the origin of the link" if far and matters else ""
    if any(_is_gltf(part) for one in link.solids for part in one.parts):
        return ""  # whose axes programs do not agree on
    x, y, z = center
    turned = {"x": (-x, y, z), "y": (x, -y, z), "z": (x, y, -z)}
    for axis, point in turned.items():
        if _outside(point, outline) <= 0:
            return f"would be inside with the other sign of {axis}"
    swapped = {"x and y": (y, x, z), "x and z": (z, y, x), "y and z": (x, z, y)}
    for axes, point in swapped.items():
        if _outside(point, outline) <= 0:
            return f"would be inside with {axes} swapped"
    return ""


def _is_gltf(part: Primitive | MeshSolid) -> bool:
    return isinstance(part, MeshSolid) and part.name.lower().endswith((".gltf", ".glb"))


def _outside(point: Vector, box: BoundingBox) -> float:
    """How far a point is outside a box along the axis where that is most, in m; 0 inside."""
    return max(max(low - x, 0.0, x - high) for x, low, high in zip(point, *box, strict=True))


def _is_unlike_shape(link: LinkInertia) -> bool:
    """True if people wrote the tensor and it is not that of the shapes.

    With a mesh, the collision is only similar; then only a round tensor is reported.
    """
    if link.is_noise or link.body.is_ground or not link.differs or link.is_marker:
        return False
    return not _is_in_two_units(link) if link.is_measured else link.is_round


def _sort_placeholders(
    placeholders: list[LinkInertia],
    matters: Matters,
    by_macro: Collection[str],
    found: dict[InertiaDefect, list[LinkInertia]],
) -> None:
    """Placeholders next to a mesh, or without a shape, that cannot be nearly right."""
    reported = {link.tensor for link in found.get(InertiaDefect.TOO_LARGE, ())}
    for group in by_tensor(placeholders):
        free = [link for link in group if link.name not in by_macro]
        unknown = len(free) >= MANY or any(w.radius_of_gyration > WIDE for w in free)
        is_noticeable = any(matters(w.body, w.moments[2]) for w in free)
        if unknown and is_noticeable and group[0].tensor not in reported:
            found.setdefault(InertiaDefect.PLACEHOLDER, []).extend(free)
        else:
            unlike = [link for link in group if _is_unlike_shape(link)]
            if unlike:
                found.setdefault(InertiaDefect.UNLIKE_SHAPE, []).extend(unlike)

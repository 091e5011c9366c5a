"""Defects of masses and inertia tensors; for a tensor, the one that explains it best."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable
from enum import Enum
from math import dist

from urdfkit.core.spatial import ORIGIN, Vector
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot.inertia import principal_moments, scaled
from urdfkit.robot.inertials.link_comparison import (
    LARGEST_PART,
    SIGNIFICANT_PART,
    LinkInertia,
    by_tensor,
)
from urdfkit.robot.rigid_bodies import RigidBody
from urdfkit.robot.shapes import BoundingBox, MeshSolid, Primitive

if TYPE_CHECKING:
    IsSignificant = Callable[[RigidBody, float], bool]

#: Ratio to the largest possible moment from which it is reported: a link may be somewhat larger
#: than its collision shape.
MAX_MOMENT_RATIO = 2.0

#: Ratio to the moment of the uniform solid below which a central mass cannot explain it.
MIN_MOMENT_RATIO = 0.01

#: Densities of robot parts in kg/m³, from hollow plastic to lead.
MIN_PART_DENSITY, MAX_PART_DENSITY = 20.0, 12000.0
#: Shapes whose lengths differ by a larger ratio are in different units.
MAX_LENGTH_RATIO = 500.0
#: Largest distance in m of a centre of mass from a marker.
FAR_FROM_MARKER = 0.1

#: A density within this factor of the range may result from a shape drawn too small.
DENSITY_TOLERANCE = 1.2

#: A longer link in m is a building, or in millimetres; and the least mass of a building in kg.
LARGEST_LINK, LEAST_BUILDING = 100.0, 1000.0

#: Range of most densities; a correction of the unit must lead into it.
USUAL_DENSITIES = (100.0, 8000.0)

#: Distances of a centre of mass outside the shapes, as a part of their length: with a mistake that
#: explains it, and if it was left at zero, as on many links.
OUTSIDE_BY_MISTAKE, OUTSIDE_AT_ORIGIN = 0.15, 0.5

#: Distances as a part of the length of the shapes: up to which two centres of mass are equal, and
#: from which the sign of a coordinate matters.
CENTER_TOLERANCE, OFF_CENTER = 0.01, 0.05

#: Part of its rigid body's mass above which the centre of a link matters.
NOTICEABLE_MASS = 0.1

#: A radius of gyration over this, in m, is larger than most robots; and this many links with equal
#: tensors were not measured.
LARGE_GYRATION, MANY_EQUAL_TENSORS = 0.3, 3


class InertiaDefect(Enum):
    """The defect of a link's inertial."""

    INDEFINITE = "indefinite"
    TRIANGLE_INEQUALITY = "triangle inequality"
    TOO_LARGE = "too large"
    TOO_SMALL = "too small"
    WRONG_AXES = "wrong axes"
    ABOUT_ORIGIN = "about origin"
    UNLIKE_SHAPE = "unlike shape"
    PLACEHOLDER = "placeholder"
    DENSITY = "density"
    CENTER_OF_MASS = "center of mass"


def find_defects(
    inertias: Iterable[LinkInertia], is_significant: IsSignificant, by_macro: Collection[str]
) -> dict[InertiaDefect, list[LinkInertia]]:
    """The links with each defect.

    Args:
        is_significant: True for a moment in kg·m² that is a significant part of a rigid body's.
        by_macro: names of links whose tensor one macro defines for links of different mass.
    """
    defects: dict[InertiaDefect, list[LinkInertia]] = {}
    placeholders: list[LinkInertia] = []
    for link in inertias:
        if defect := _defect(link, is_significant):
            defects.setdefault(defect, []).append(link)
        elif link.is_placeholder and not link.is_measured:
            placeholders.append(link)
        elif _is_unlike_shape(link):
            defects.setdefault(InertiaDefect.UNLIKE_SHAPE, []).append(link)
        if center_is_outside(link) and link.mass >= SIGNIFICANT_PART * link.body.mass:
            defects.setdefault(InertiaDefect.CENTER_OF_MASS, []).append(link)
    _sort_placeholders(placeholders, is_significant, by_macro, defects)
    return defects


def _defect(link: LinkInertia, is_significant: IsSignificant) -> InertiaDefect | None:
    """The defect that makes a tensor or mass impossible or implausible; None without one."""
    if link.is_indefinite:
        return InertiaDefect.INDEFINITE
    if link.breaks_triangle:
        return InertiaDefect.TRIANGLE_INEQUALITY
    if link.is_negligible or not link.is_measured or link.body.is_ground:
        return None
    if _is_of_unknown_size(link):
        return None
    density = implausible_density(link)
    if density is not None and unit_mistake(link):
        return InertiaDefect.DENSITY
    assert link.expected is not None
    high, expected = link.moments[2], principal_moments(link.expected)[2]
    # Moments of a part with a usual density: the mass alone is wrong, though it may be negligible.
    outside = density if link.has_round_numbers else density_outside(link)
    is_mass_wrong = (
        outside is not None
        and USUAL_DENSITIES[0] <= outside * high / expected <= USUAL_DENSITIES[1]
    )
    if high > MAX_MOMENT_RATIO * link.largest_possible and is_significant(link.body, high):
        return InertiaDefect.DENSITY if is_mass_wrong else InertiaDefect.TOO_LARGE
    if high < MIN_MOMENT_RATIO * expected and is_significant(link.body, expected):
        # A mass that is too large explains both the density and the moments.
        is_too_dense = density is not None and density > MAX_PART_DENSITY
        return InertiaDefect.DENSITY if is_mass_wrong or is_too_dense else InertiaDefect.TOO_SMALL
    if density is not None:
        return InertiaDefect.DENSITY
    return _misplaced(link) if is_significant(link.body, high) else None


def _misplaced(link: LinkInertia) -> InertiaDefect | None:
    """The defect of a tensor of plausible size that is about another point or other axes."""
    if link.is_about_origin:
        return InertiaDefect.ABOUT_ORIGIN
    is_turned = link.is_at_wrong_axes or link.turned_axis is not None
    return InertiaDefect.WRONG_AXES if is_turned else None


def _is_of_unknown_size(link: LinkInertia) -> bool:
    """True if the shapes are markers, or in metres and in millimetres (MSH012, GEO004)."""
    is_small_marker = link.is_marker and link.radius_of_gyration < LARGE_GYRATION
    return is_small_marker or link.lengths_differ(MAX_LENGTH_RATIO)


#: Names of links that are filled with gas.
_BALLOONS = ("balloon", "blimp", "airship")


def implausible_density(link: LinkInertia) -> float | None:
    """The density in kg/m³ if it is implausible, and the mass a significant part of its body's."""
    is_significant = link.mass >= SIGNIFICANT_PART * link.body.mass
    return density_outside(link) if is_significant else None


def density_outside(link: LinkInertia) -> float | None:
    """The density in kg/m³ if it is implausible; the bound nearer to a plausible one."""
    if link.densities is None or any(word in link.name.lower() for word in _BALLOONS):
        return None
    low, high = link.densities
    if low > MAX_PART_DENSITY * DENSITY_TOLERANCE:
        return low
    return high if high < MIN_PART_DENSITY / DENSITY_TOLERANCE else None


def unit_mistake(link: LinkInertia) -> str:
    """The unit that explains an implausible density: ``g``, ``mm``, or empty."""
    if link.densities is None or link.solid is None or link.expected is None:
        return ""
    low, high = link.densities
    if low > MAX_PART_DENSITY and USUAL_DENSITIES[0] <= low / 1000 <= USUAL_DENSITIES[1]:
        consistent = link.fits(link.expected, 3)
        return "g" if consistent or link.fits(scaled(link.expected, 1e-3), 10) else ""
    longest = max(link.solid.bounds.edges)
    plausible = USUAL_DENSITIES[0] <= high * 1e9 <= USUAL_DENSITIES[1]
    is_no_building = longest > LARGEST_LINK and link.mass < LEAST_BUILDING
    is_light = high < MIN_PART_DENSITY
    return "mm" if longest > LARGEST_PART and (plausible or (is_light and is_no_building)) else ""


def center_is_outside(link: LinkInertia) -> float | None:
    """Distance of the centre of mass from the shapes, in m, if it is probably a mistake.

    The distance exceeds the size of the shapes, or a mistake explains it.
    """
    if not link.is_measured or link.solid is None or link.body.is_ground:
        return None
    center = link.inertial.origin.position
    # The bounding box of a part contains its centre, and its edges are at least longest / sqrt(3).
    if any(2 * dist(center, part.origin.position) <= part.longest for part in link.solid.parts):
        return None
    distance, longest = _outside(center, link.bounds), max(link.bounds.edges)
    if link.is_marker and distance < FAR_FROM_MARKER:
        return None
    if distance > longest or (distance > OUTSIDE_BY_MISTAKE * longest and not link.is_marker):
        return distance if distance > longest or center_mistake(link) else None
    return None


def distance_outside(link: LinkInertia) -> float:
    """Distance of the centre of mass from the box of the shapes, in m; 0 inside, or if unknown."""
    if not link.is_measured or link.solid is None:
        return 0.0
    return _outside(link.inertial.origin.position, link.bounds)


def center_mistake(link: LinkInertia) -> str:
    """The mistake that explains a centre of mass outside the shapes: a predicate on the centre."""
    center, bounds = link.inertial.origin.position, link.bounds
    if center == ORIGIN:
        far = _outside(center, bounds) > OUTSIDE_AT_ORIGIN * max(bounds.edges)
        is_heavy = link.mass > NOTICEABLE_MASS * link.body.mass
        return "was left at the origin of the link" if far and is_heavy else ""
    if any(_is_gltf(part) for solid in link.solids for part in solid.parts):
        return ""  # programs disagree on the axes of glTF
    x, y, z = center
    turned = {"x": (-x, y, z), "y": (x, -y, z), "z": (x, y, -z)}
    for axis, point in turned.items():
        if _outside(point, bounds) <= 0:
            return f"would be inside with the other sign of {axis}"
    swapped = {"x and y": (y, x, z), "x and z": (z, y, x), "y and z": (x, z, y)}
    for axes, point in swapped.items():
        if _outside(point, bounds) <= 0:
            return f"would be inside with {axes} swapped"
    return ""


def mirrored_center(link: LinkInertia) -> tuple[str, Vector] | None:
    """The axis of the coordinate with the wrong sign, and the centre of the uniform solid.

    If the centre of mass is that of the solid but for a sign: this is hardly a coincidence.
    """
    if not link.is_measured or link.solid is None or link.is_marker or link.solid.volume <= 0:
        return None
    if any(_is_gltf(part) for part in link.solid.parts):
        return None
    expected, longest = link.solid.properties(link.mass).center, max(link.bounds.edges)
    center = link.inertial.origin.position
    near = CENTER_TOLERANCE * longest
    opposite = [
        axis
        for axis, own, other in zip("xyz", center, expected, strict=True)
        if abs(own + other) <= near < OFF_CENTER * longest <= abs(own)
    ]
    equal = sum(abs(own - other) <= near for own, other in zip(center, expected, strict=True))
    return (opposite[0], expected) if len(opposite) == 1 and equal == 2 else None


def _is_gltf(part: Primitive | MeshSolid) -> bool:
    return isinstance(part, MeshSolid) and part.name.lower().endswith((".gltf", ".glb"))


def _outside(point: Vector, box: BoundingBox) -> float:
    """Largest distance of a point from a box along an axis, in m; 0 inside."""
    return max(max(low - x, 0.0, x - high) for x, low, high in zip(point, *box, strict=True))


def _is_unlike_shape(link: LinkInertia) -> bool:
    """True if a tensor was written by hand and differs from that of the shapes.

    A collision is only similar to an unmeasured mesh; then only round tensors are reported.
    """
    if link.is_negligible or link.body.is_ground or not link.differs or link.is_marker:
        return False
    return not link.lengths_differ(MAX_LENGTH_RATIO) if link.is_measured else link.has_round_numbers


def _sort_placeholders(
    placeholders: list[LinkInertia],
    is_significant: IsSignificant,
    by_macro: Collection[str],
    defects: dict[InertiaDefect, list[LinkInertia]],
) -> None:
    """Add the placeholders, next to a mesh or without a shape, that cannot be nearly right."""
    reported = {link.tensor for link in defects.get(InertiaDefect.TOO_LARGE, ())}
    for group in by_tensor(placeholders):
        free = [link for link in group if link.name not in by_macro]
        is_large = any(link.radius_of_gyration > LARGE_GYRATION for link in free)
        unknown = is_large or len(free) >= MANY_EQUAL_TENSORS
        is_noticeable = any(is_significant(link.body, link.moments[2]) for link in free)
        if unknown and is_noticeable and group[0].tensor not in reported:
            defects.setdefault(InertiaDefect.PLACEHOLDER, []).extend(free)
        else:
            unlike = [link for link in group if _is_unlike_shape(link)]
            if unlike:
                defects.setdefault(InertiaDefect.UNLIKE_SHAPE, []).extend(unlike)

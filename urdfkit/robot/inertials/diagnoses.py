"""Which inertias are doubtful, each given to the one rule that tells it best.

A tensor can be wrong in several ways at once, and one finding says enough. Meshes are not measured
here; a link that has one is judged only where its numbers give themselves away.
"""

from __future__ import annotations

from math import dist
from typing import TYPE_CHECKING

from urdfkit.core.spatial import ORIGIN
from urdfkit.robot.inertia import principal_moments, scaled
from urdfkit.robot.inertials.link_comparison import SIGNIFICANT, LinkInertia, by_tensor
from urdfkit.robot.shapes import MeshSolid

if TYPE_CHECKING:
    from urdfkit.core.spatial import Vector
    from urdfkit.robot.inertials.masses import Masses
    from urdfkit.robot.shapes import BoundingBox, Primitive

#: Times the largest possible moment that is taken for impossible: the matter of a link may reach
#: somewhat farther than its collision shape.
TOO_LARGE = 2.0

#: Part of the uniform solid's moment below which no mass in the middle explains it.
TOO_SMALL = 0.01

#: Densities of robot parts in kg/m^3, from hollow plastic to lead.
LIGHTEST, HEAVIEST = 20.0, 12000.0

#: A density outside by less than this factor may be that of a shape drawn a little too small.
NEAR = 1.2

#: Densities of most of them; a slip of the unit must lead to one of these.
USUAL = (100.0, 8000.0)

#: Parts of robots are smaller than this, in m; their sizes in millimetres are larger.
LARGEST_PART = 10.0

#: A centre of mass outside the shapes by this part of their length, where a slip explains it; and
#: where it stands at zero, as on many links whose makers knew it and did not mind.
SLIPPED, LEFT_BEHIND = 0.15, 0.5

#: Part of its rigid body's mass that a link has whose centre somebody should have looked up.
NOTICED = 0.1

#: A radius of gyration over this, in m, is larger than most robots are; and of so many links with
#: equal tensors nobody has measured any.
WIDE, MANY = 0.3, 3


def diagnoses(masses: Masses) -> dict[str, list[LinkInertia]]:
    """The doubtful inertias by the code of the rule that tells them."""
    found: dict[str, list[LinkInertia]] = {}
    placeholders: list[LinkInertia] = []
    for weighed in masses.weighed:
        code = _judge(weighed, masses)
        if code:
            found.setdefault(code, []).append(weighed)
        elif weighed.is_placeholder and not weighed.is_measured:
            placeholders.append(weighed)
        elif _is_unlike_shape(weighed):
            found.setdefault("INE008", []).append(weighed)
        if center_is_outside(weighed) and weighed.mass >= SIGNIFICANT * weighed.body.mass:
            found.setdefault("INE011", []).append(weighed)
    _sort_placeholders(placeholders, masses, found)
    return found


def _judge(weighed: LinkInertia, masses: Masses) -> str:
    """The rule that tells what is impossible or implausible; empty if nothing is."""
    if weighed.is_indefinite:
        return "INE002"
    if weighed.breaks_triangle:
        return "INE003"
    if weighed.is_noise or not weighed.is_measured or weighed.body.is_ground:
        return ""
    implausible = implausible_density(weighed) is not None
    if implausible and unit_mistake(weighed):
        return "INE010"
    assert weighed.expected is not None
    high, expected = weighed.moments[2], principal_moments(weighed.expected)[2]
    if high > TOO_LARGE * weighed.largest_possible and masses.matters(weighed.body, high):
        return "INE006"
    if high < TOO_SMALL * expected and masses.matters(weighed.body, expected):
        return "INE007"
    if implausible:
        return "INE010"
    if weighed.is_at_wrong_axes and masses.matters(weighed.body, high):
        return "INE015"
    return ""


def implausible_density(weighed: LinkInertia) -> float | None:
    """The density in kg/m^3 if no material of robots has it; the one nearer to a material's."""
    if weighed.densities is None or weighed.mass < SIGNIFICANT * weighed.body.mass:
        return None
    low, high = weighed.densities
    if low > HEAVIEST * NEAR:
        return low
    return high if high < LIGHTEST / NEAR else None


def unit_mistake(weighed: LinkInertia) -> str:
    """The unit that explains an implausible density: ``g``, ``mm``, or nothing."""
    if weighed.densities is None or weighed.solid is None or weighed.expected is None:
        return ""
    low, high = weighed.densities
    if low > HEAVIEST and USUAL[0] <= low / 1000 <= USUAL[1]:
        consistent = weighed.fits(weighed.expected, 3)
        return "g" if consistent or weighed.fits(scaled(weighed.expected, 1e-3), 3) else ""
    plausible = USUAL[0] <= high * 1e9 <= USUAL[1]
    return "mm" if plausible and max(weighed.solid.bounds.edges) > LARGEST_PART else ""


def center_is_outside(weighed: LinkInertia) -> float | None:
    """How far the centre of mass is outside the shapes, in m, if that is hardly meant.

    More than their size; or less, where a slip explains it.
    """
    if not weighed.is_measured or weighed.solid is None or weighed.body.is_ground:
        return None
    center = weighed.inertial.origin.position
    # A box around a part is at least its length by the root of 3 long, and holds its middle.
    if any(2 * dist(center, part.origin.position) <= part.longest for part in weighed.solid.parts):
        return None
    distance, longest = _outside(center, weighed.outline), max(weighed.outline.edges)
    if distance > longest or (distance > SLIPPED * longest and not weighed.is_marker):
        return distance if distance > longest or center_mistake(weighed) else None
    return None


def center_mistake(weighed: LinkInertia) -> str:
    """What explains that the centre of mass is outside: a predicate whose subject is the centre."""
    center, outline = weighed.inertial.origin.position, weighed.outline
    if center == ORIGIN:
        far = _outside(center, outline) > LEFT_BEHIND * max(outline.edges)
        matters = weighed.mass > NOTICED * weighed.body.mass
        return "was left at the origin of the link" if far and matters else ""
    if any(_is_gltf(part) for one in weighed.solids for part in one.parts):
        return ""  # whose axes programs do not agree on
    x, y, z = center
    turned = {"x": (-x, y, z), "y": (x, -y, z), "z": (x, y, -z)}
    for axis, point in turned.items():
        if _outside(point, outline) <= 0:
            return f"would be inside with the other sign of {axis}"
    swapped = {"x and y": (y, x, z), "x and z": (z, y, x), "y and z": (x, z, y)}
    for axes, point in swapped.items():
        if _outside(point, outline) <= 0:
            return f"would be inside with {axes} interchanged"
    return ""


def _is_gltf(part: Primitive | MeshSolid) -> bool:
    return isinstance(part, MeshSolid) and part.name.lower().endswith((".gltf", ".glb"))


def _outside(point: Vector, box: BoundingBox) -> float:
    """How far a point is outside a box along the axis where that is most, in m; 0 inside."""
    return max(max(low - x, 0.0, x - high) for x, low, high in zip(point, *box, strict=True))


def _is_unlike_shape(weighed: LinkInertia) -> bool:
    """True if people wrote the tensor and it is not that of the shapes.

    Beside a mesh the collision is a rough likeness; then only a round tensor is doubted.
    """
    if weighed.is_noise or weighed.body.is_ground or not weighed.differs or weighed.is_marker:
        return False
    return weighed.is_measured or weighed.is_round


def _sort_placeholders(
    placeholders: list[LinkInertia], masses: Masses, found: dict[str, list[LinkInertia]]
) -> None:
    """Placeholders beside a mesh, or without a shape, that cannot be near the truth."""
    reported = {weighed.tensor for weighed in found.get("INE006", ())}
    by_macro = {link.name for links in masses.shared_by_macro.values() for link in links}
    for group in by_tensor(placeholders):
        free = [weighed for weighed in group if weighed.link.name not in by_macro]
        unknown = len(free) >= MANY or any(w.radius_of_gyration > WIDE for w in free)
        shape_mass = any(masses.matters(w.body, w.moments[2]) for w in free)
        if unknown and shape_mass and group[0].tensor not in reported:
            found.setdefault("INE009", []).extend(free)
        else:
            unlike = [weighed for weighed in group if _is_unlike_shape(weighed)]
            if unlike:
                found.setdefault("INE008", []).extend(unlike)

"""The density computed from mass and size of a link is that of no robot material.

Hollow plastic has about 50 kg/m³, wood 600, aluminium 2700, steel 7800, lead 11300. A mass in
grams, a size in millimetres or a missing zero results in a density far outside this range: forces
and torques in the simulation are wrong. Correct the mass or the size. If most links of a robot are
wrong, they are one finding: all of them have the wrong unit. It is an info if the density is at
most a factor of two outside the range of robot parts, unless the left or right counterpart has
another mass, and for a light body of more than 1 m³, such
as a wall of a scene, unless its mass is that of a part in millimetres. Suppress this if a collision
shape is intentionally much smaller or larger than the part.

Sources:
    measured: mass over volume of 2 042 public links: median 1 180, from 238 to 6 975 for 90 %
"""

from urdfkit.checks.inertia.copies import and_more, together
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.robot.inertia import scaled
from urdfkit.robot.inertials.defects import (
    MAX_PART_DENSITY,
    MIN_PART_DENSITY,
    InertiaDefect,
    density_outside,
    unit_mistake,
)
from urdfkit.robot.inertials.diagnosis import MAX_RELATED
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import unlike
from urdfkit.robot.inertials.tensor_fix import replacement
from urdfkit.robot.samples import collision_xml, inertial_xml, link_xml
from urdfkit.text.editing.edits import rewrite

BAD = link_xml(
    "wheel",
    collision_xml('<cylinder radius="0.05" length="0.03"/>'),
    inertial_xml("350", "0.245 0.245 0.4375"),
)
FIXED = GOOD = (
    BAD.replace("350", "0.35").replace("0.245", "0.000245").replace("0.4375", "0.0004375")
)

#: A density that is too high or too low by this factor may be due to a coarse shape.
_COARSE_FACTOR = 2.0
#: In m³: volume above which a body is not a robot part.
_MAX_M3 = 1.0

#: Help if most links of a robot are wrong, by the unit in which the values are written.
_UNIT_HELPS = {
    "g": "the masses are probably in g: divide them by 1000, and the tensors with them",
    "mm": 'the sizes are probably in mm: write them in m, and scale="0.001 0.001 0.001" for meshes',
    "": "write masses in kg, and sizes in m",
}


@rule(
    Severity.WARNING,
    confidence=Confidence.INFERRED,
    help="correct the mass in kg, or the size in m",
    computes_fix=True,
)
def check(context: Context) -> Findings:
    unequal = {  # left and right
        link.name
        for pair in context.masses.symmetric_pairs
        if unlike(*pair) == "mass"
        for link in pair
    }
    findings = [
        (inertia, _finding(inertia, is_certain=inertia.name in unequal))
        for inertia in context.masses.defects.get(InertiaDefect.DENSITY, ())
    ]
    if context.masses.consistently_wrong:
        yield _of_the_robot(findings)
    else:
        yield from together(findings)


def _of_the_robot(findings: list[tuple[LinkInertia, Finding]]) -> Finding:
    """One finding for most links of a robot, which have the wrong unit."""
    (_, worst), *others = sorted(findings, key=lambda pair: -pair[1].weight)
    unit = _common_unit([inertia for inertia, _ in findings])
    fixes = [finding.fix for _, finding in findings]
    edits = [edit for fix in fixes if fix for edit in fix.edits]
    return worst._replace(
        message=f"{worst.message} ({and_more(others)}: most links of the robot)",
        help=_UNIT_HELPS[unit],
        related=tuple(
            Related(inertia.at.span, finding.message) for inertia, finding in others[:MAX_RELATED]
        ),
        fix=Fix(f"divide {len(fixes)} masses by 1000", tuple(dict.fromkeys(edits)))
        if all(fixes)
        else None,
    )


def _common_unit(links: list[LinkInertia]) -> str:
    """The unit that explains most of the links; empty if there is none."""
    units = [unit_mistake(inertia) for inertia in links]
    return next((unit for unit in ("g", "mm") if 2 * units.count(unit) > len(links)), "")


def _finding(inertia: LinkInertia, *, is_certain: bool) -> Finding:
    density = density_outside(inertia)
    assert density is not None
    assert inertia.inertial.mass is not None
    # That of the shape in the message; the bound may be of another one, or of a convex hull.
    volume = inertia.solid.volume if inertia.solid else 0.0
    shown = inertia.mass / volume if volume else density
    return Finding(
        inertia.inertial.mass,
        f"link '{inertia.link.name}': {inertia.mass:g} kg in a {inertia.solid} make "
        f"{shown:.3g} kg/m³; robot parts have {MIN_PART_DENSITY:g} to {MAX_PART_DENSITY:g}",
        _advice(inertia),
        _in_kilograms(inertia) if unit_mistake(inertia) == "g" else None,
        weight=max(density / MAX_PART_DENSITY, MIN_PART_DENSITY / max(density, 1e-300)),
        group_key="density",
        severity=Severity.INFO if _is_harmless(inertia, density) and not is_certain else None,
    )


def _is_harmless(inertia: LinkInertia, density: float) -> bool:
    """True for a density near a bound, and for the walls of a scene."""
    is_near = MIN_PART_DENSITY / _COARSE_FACTOR <= density <= MAX_PART_DENSITY * _COARSE_FACTOR
    is_wall = (
        density < MIN_PART_DENSITY and inertia.solid is not None and inertia.solid.volume > _MAX_M3
    )
    return is_near or (is_wall and unit_mistake(inertia) != "mm")


def _in_kilograms(inertia: LinkInertia) -> Fix | None:
    """Divides the mass by 1000, and also a tensor that was computed from the mass in grams."""
    assert inertia.inertial.mass is not None
    assert inertia.expected is not None
    at = inertia.inertial.mass.at
    edits = rewrite(at, f"{inertia.mass / 1000:g}")
    if edits and inertia.fits(inertia.expected, 3):
        tensor = replacement(inertia, scaled(inertia.tensor, 1e-3))
        edits = (*edits, *tensor.edits) if tensor else None
    return Fix.of(f"write {inertia.mass / 1000:g} kg", edits)


def _advice(inertia: LinkInertia) -> str:
    unit = unit_mistake(inertia)
    if unit == "g":
        return f"the mass is probably in g: write {inertia.mass / 1000:g}, and the tensor in kg·m²"
    return "the size is probably in mm: write it in m" if unit == "mm" else ""

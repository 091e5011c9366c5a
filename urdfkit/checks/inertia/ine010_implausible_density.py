"""Mass and size of a link make a density that no material of robots has.

Hollow plastic has some 50 kg/m^3, wood 600, aluminium 2700, steel 7800, lead 11300. A mass in
grams, a size in millimetres or a forgotten zero puts a link far outside: it falls, grips and tips
like nothing real, and motors that hold the robot in the simulation are too weak or too strong.
Correct the mass or the size. Most links of one robot are told as one: somebody mistook a unit for
all of them. Where a collision shape is deliberately much smaller or larger than the part, ignore
this.

Sources:
    measured: mass over volume of 2 042 public links: median 1 180, from 238 to 6 975 for 90 %
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.checks.inertia.copies import and_more, together
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertia import scaled
from urdfkit.robot.inertials.diagnoses import HEAVIEST, LIGHTEST, implausible_density, unit_mistake
from urdfkit.robot.inertials.diagnosis import MAX_RELATED, replacement
from urdfkit.text.diagnostic import Confidence, Fix, Related, Severity
from urdfkit.text.editing.edits import rewrite

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.link_comparison import LinkInertia

BAD = """\
<link name="wheel">
  <collision>
    <geometry><cylinder radius="0.05" length="0.03"/></geometry>
  </collision>
  <inertial>
    <mass value="350"/>
    <inertia ixx="0.245" ixy="0" ixz="0" iyy="0.245" iyz="0" izz="0.4375"/>
  </inertial>
</link>"""
GOOD = BAD.replace("350", "0.35").replace("0.245", "0.000245").replace("0.4375", "0.0004375")
FIXED = GOOD


@rule(
    "INE010",
    "implausible-density",
    Severity.WARNING,
    help="correct the mass in kg, or the size in m",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    found = [(one, _finding(one)) for one in subject.masses.diagnoses.get("INE010", ())]
    if subject.masses.consistently_wrong:
        yield _of_the_robot(found)
    else:
        yield from together(found)


def _of_the_robot(found: list[tuple[LinkInertia, Finding]]) -> Finding:
    """One for most links of a robot: somebody took one unit for another."""
    (_, worst), *others = sorted(found, key=lambda pair: -pair[1].weight)
    in_grams = [one for one, _ in found if unit_mistake(one) == "g"]
    fixes = [finding.fix for _, finding in found]
    edits = [edit for fix in fixes if fix for edit in fix.edits]
    return worst._replace(
        message=f"{worst.message} ({and_more(others)}: most links of the robot)",
        help="the masses are probably in g: divide them by 1000, and the tensors with them"
        if 2 * len(in_grams) > len(found)
        else "one slip made them all: masses are in kg, and sizes in m",
        related=tuple(
            Related(one.at.span, finding.message) for one, finding in others[:MAX_RELATED]
        ),
        fix=Fix(f"divide {len(fixes)} masses by 1000", tuple(dict.fromkeys(edits)))
        if all(fixes)
        else None,
    )


def _finding(weighed: LinkInertia) -> Finding:
    density = implausible_density(weighed)
    assert density is not None
    assert weighed.inertial.mass is not None
    return Finding(
        weighed.inertial.mass,
        f"link '{weighed.link.name}': {weighed.mass:g} kg in a {weighed.solid} make "
        f"{density:.3g} kg/m^3; parts of robots have {LIGHTEST:g} to {HEAVIEST:g}",
        _advice(weighed),
        _in_kilograms(weighed) if unit_mistake(weighed) == "g" else None,
        confidence=Confidence.INFERRED,
        weight=max(density / HEAVIEST, LIGHTEST / density),
        alike="density",
    )


def _in_kilograms(weighed: LinkInertia) -> Fix | None:
    """The mass by 1000, and the tensor as well if it was computed from the mass in grams."""
    assert weighed.inertial.mass is not None
    assert weighed.expected is not None
    at = weighed.inertial.mass.at
    edits = rewrite(at, f"{weighed.mass / 1000:g}")
    if edits and weighed.fits(weighed.expected, 3):
        tensor = replacement(weighed, scaled(weighed.tensor, 1e-3))
        edits = (*edits, *tensor.edits) if tensor else None
    return Fix.of(f"write {weighed.mass / 1000:g} kg", edits)


def _advice(weighed: LinkInertia) -> str:
    unit = unit_mistake(weighed)
    if unit == "g":
        return f"the mass is probably in g: write {weighed.mass / 1000:g}, and the tensor in kg m^2"
    return "the size is probably in mm: write it in m" if unit == "mm" else ""

"""A moment of inertia is larger than the mass can have within the shapes of the link.

If all of the mass sat at the point that is farthest from the centre of mass, at the distance r, the
moment would be mass x r^2; no body of that extent has more. Such a link turns like a flywheel:
Gazebo needs a huge torque to spin a wheel up and brake it, the robot tips and drifts, and
light links with it make the solver unstable. The tensor comes from another link, in another unit,
or is a stand-in. Compute it from mass and size: for a box of x, y, z it is
`ixx = mass / 12 * (y*y + z*z)`, for a cylinder along z `ixx = iyy = mass / 12 * (3*r*r + l*l)` and
`izz = mass / 2 * r*r`, for a sphere `2 / 5 * mass * r*r`.

Sources:
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertials.diagnosis import advice, as_solid, of_unlike_shape, replacement
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.link_comparison import LinkInertia
    from urdfkit.robot.inertials.masses import Masses

BAD = """\
<link name="wheel">
  <collision>
    <geometry><cylinder radius="0.06" length="0.05"/></geometry>
  </collision>
  <inertial>
    <mass value="0.5"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/>
  </inertial>
</link>"""
FIXED = GOOD = BAD.replace(
    'ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"',
    'ixx="0.000554167" ixy="0" ixz="0" iyy="0.000554167" iyz="0" izz="0.0009"',
)

#: A radius of gyration this many times the reach of the link is worth a word.
_STRIKING = 10.0

#: A part of the inertia of a whole rigid body that is worth a word.
_SHARE = 0.1


@rule(
    "INE006",
    "inertia-too-large-for-geometry",
    Severity.WARNING,
    help="compute ixx, iyy and izz from mass and size (urdfkit explain INE006 has the formulas)",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    masses = subject.masses
    claimed = masses.diagnoses.get("INE006", ())
    # One value for all small links, below which no moment goes, is one decision.
    found = ((weighed, _finding(weighed, masses)) for weighed in claimed)
    yield from together(found, by=lambda weighed: max(weighed.diagonal))


def _finding(weighed: LinkInertia, masses: Masses) -> Finding:
    diagnosis = of_unlike_shape(weighed, masses)
    high, bound = weighed.moments[2], weighed.largest_possible
    return Finding(
        weighed.at,
        f"link '{weighed.link.name}': {high:.3g} kg m^2 is {high / bound:.3g} times the most that "
        f"{weighed.mass:g} kg can have within {weighed.reach:.3g} m of the centre of mass; "
        f"{as_solid(weighed)}{_radius(weighed)}{_share(weighed, masses)}",
        advice(weighed, diagnosis),
        replacement(weighed, diagnosis.tensor),
        confidence=Confidence.INFERRED,
        weight=high / bound,
    )


def _radius(weighed: LinkInertia) -> str:
    radius = weighed.radius_of_gyration
    striking = radius > _STRIKING * weighed.reach
    return f"; its radius of gyration is {radius:.3g} m" if striking else ""


def _share(weighed: LinkInertia, masses: Masses) -> str:
    """How much of a simulated body's inertia it is, if fixed joints make it a part of one."""
    if sum(link.mass > 0 for link, _ in weighed.body.links) < 2:
        return ""
    share = weighed.moments[2] / masses.moments_of(weighed.body)[2]
    top = weighed.body.top.name
    return f"; it is {share:.0%} of what a simulator merges into '{top}'" if share > _SHARE else ""

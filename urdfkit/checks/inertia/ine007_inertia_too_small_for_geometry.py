"""The moments of inertia are less than a hundredth of those of the shape.

Some mass may sit in the middle, but not that much of it. The link turns at a touch: controllers
tuned on it shake, and beside heavier links the solver becomes unstable. The tensor was computed in
another unit or for another link, or the mass was raised and the tensor forgotten. Compute it from
mass and size: for a box of x, y, z it is `ixx = mass / 12 * (y*y + z*z)`, for a cylinder along z
`ixx = iyy = mass / 12 * (3*r*r + l*l)` and `izz = mass / 2 * r*r`, for a sphere
`2 / 5 * mass * r*r`.

Sources:
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.inertials.diagnosis import advice, as_solid, of_unlike_shape, replacement
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.link_comparison import LinkInertia
    from urdfkit.robot.inertials.masses import Masses

BAD = """\
<link name="chassis">
  <collision>
    <geometry><box size="0.5 0.3 0.1"/></geometry>
  </collision>
  <inertial>
    <mass value="8"/>
    <inertia ixx="6.67e-8" ixy="0" ixz="0" iyy="1.73e-7" iyz="0" izz="2.27e-7"/>
  </inertial>
</link>"""
FIXED = GOOD = BAD.replace(
    'ixx="6.67e-8" ixy="0" ixz="0" iyy="1.73e-7" iyz="0" izz="2.27e-7"',
    'ixx="0.0666667" ixy="0" ixz="0" iyy="0.173333" iyz="0" izz="0.226667"',
)


@rule(
    "INE007",
    "inertia-too-small-for-geometry",
    Severity.WARNING,
    help="compute ixx, iyy and izz from mass and size (urdfkit explain INE007 has the formulas)",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    masses = subject.masses
    claimed = masses.diagnoses.get("INE007", ())
    yield from together((weighed, _finding(weighed, masses)) for weighed in claimed)


def _finding(weighed: LinkInertia, masses: Masses) -> Finding:
    diagnosis = of_unlike_shape(weighed, masses)
    assert weighed.expected is not None
    high, expected = weighed.moments[2], principal_moments(weighed.expected)[2]
    return Finding(
        weighed.at,
        f"link '{weighed.link.name}' of {weighed.mass:g} kg has at most {high:.3g} kg m^2, "
        f"1/{expected / high:.0f} of its shape; {as_solid(weighed)}",
        advice(weighed, diagnosis),
        replacement(weighed, diagnosis.tensor),
        confidence=Confidence.INFERRED,
        weight=expected / high,
    )

"""The inertia tensor is not that of the link's shape.

It is possible, but a solid of uniform density has clearly more or less, or has it about other axes.
Hollow parts have up to twice as much as solid ones, and a motor in the middle means less; where
neither is so, the numbers were guessed. For a light link, or one that is fixed to a heavy one, that
hardly matters; a wheel or an arm moves differently than it should. Write the tensor of the shape,
or ignore this for a link whose tensor you know.

Sources:
    Moments of inertia: https://en.wikipedia.org/wiki/List_of_moments_of_inertia
    Gazebo Classic, inertia: https://classic.gazebosim.org/tutorials?tut=inertia
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertials.diagnosis import advice, as_solid, of_unlike_shape, replacement, values
from urdfkit.text.diagnostic import Confidence, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="imu">
  <collision>
    <geometry><box size="0.05 0.05 0.05"/></geometry>
  </collision>
  <inertial>
    <mass value="0.01"/>
    <inertia ixx="1e-6" ixy="0" ixz="0" iyy="1e-6" iyz="0" izz="1e-6"/>
  </inertial>
</link>"""
FIXED = GOOD = BAD.replace('"1e-6"', '"4.16667e-06"')


@rule(
    "INE008",
    "inertia-differs-from-geometry",
    Severity.INFO,
    help="compute ixx, iyy and izz from mass and size (urdfkit explain INE006 has the formulas)",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    masses = subject.masses
    for weighed in masses.diagnoses.get("INE008", ()):
        assert weighed.expected is not None
        diagnosis = of_unlike_shape(weighed, masses)
        ratios = weighed.ratios(weighed.expected)
        yield Finding(
            weighed.at,
            f"link '{weighed.link.name}' of {weighed.mass:g} kg has moments of inertia of "
            f"{values(weighed.diagonal)}; {as_solid(weighed)}",
            advice(weighed, diagnosis),
            replacement(weighed, diagnosis.tensor),
            confidence=Confidence.INFERRED,
            weight=max(*ratios, 1 / max(min(ratios), 1e-9)),
            alike="other shape",
        )

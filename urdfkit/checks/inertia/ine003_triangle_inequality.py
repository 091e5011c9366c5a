"""The moments of inertia break the triangle inequality.

For real matter no principal moment exceeds the sum of the other two. MuJoCo and the newer Gazebo
refuse such a body; engines that accept it gain energy from nothing, and controllers that compute
with it are wrong. One moment has a slip of a digit, a row was left out, or the tensor belongs to
another frame. Take it anew from the CAD program, or compute it from the shape.

Sources:
    Traversaro et al. 2016, physical consistency: https://arxiv.org/abs/1610.08703
    Wensing et al. 2017, physical consistency: https://arxiv.org/abs/1701.04395
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    gazebosim/ros_gz#155: https://github.com/gazebosim/ros_gz/issues/155
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertials.diagnosis import of_impossible, replacement
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.link_comparison import LinkInertia
    from urdfkit.robot.inertials.masses import Masses

BAD = """\
<link name="arm">
  <inertial>
    <mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.15"/>
  </inertial>
</link>"""
GOOD = BAD.replace('"0.15"', '"0.015"')
FIXED = GOOD


@rule(
    "INE003",
    "triangle-inequality",
    Severity.ERROR,
    help="take the tensor about the centre of mass anew, from the CAD program or from the shape",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    masses = subject.masses
    claimed = masses.diagnoses.get("INE003", ())
    yield from together((weighed, _finding(weighed, masses)) for weighed in claimed)


def _finding(weighed: LinkInertia, masses: Masses) -> Finding:
    low, middle, high = weighed.moments
    which = "moments" if weighed.is_diagonal else "principal moments"
    diagnosis = of_impossible(weighed, masses)
    return Finding(
        weighed.at,
        f"link '{weighed.link.name}': the {which} of inertia violate the triangle inequality: "
        f"{high:.3g} > {low:.3g} + {middle:.3g} kg m^2",
        str(diagnosis),
        replacement(weighed, diagnosis.tensor),
        weight=(high - low - middle) / high,
    )

"""An inertia tensor has a negative moment about some axis.

No body resists turning by turning faster. The three principal moments, the eigenvalues of the
matrix, must all be positive; that of the diagonal is not enough, for large products of inertia
make one of them negative. Gazebo and MuJoCo refuse such a robot, other engines blow up. Most often
the numbers stand in the wrong order (URDF wants ixx ixy ixz iyy iyz izz, SDF and many programs
ixx iyy izz first) or the products have the opposite sign.

Sources:
    Traversaro et al. 2016, physical consistency: https://arxiv.org/abs/1610.08703
    sdformat, Link.cc: https://github.com/gazebosim/sdformat/blob/main/src/Link.cc
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertials.diagnosis import of_impossible, replacement, values
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.link_comparison import LinkInertia
    from urdfkit.robot.inertials.masses import Masses

BAD = """\
<link name="arm">
  <inertial>
    <mass value="2"/>
    <inertia ixx="0.03" ixy="0.02" ixz="0.01" iyy="0.001" iyz="0" izz="0"/>
  </inertial>
</link>"""
GOOD = BAD.replace(
    'ixy="0.02" ixz="0.01" iyy="0.001" iyz="0" izz="0"',
    'ixy="0.001" ixz="0" iyy="0.02" iyz="0" izz="0.01"',
)
FIXED = GOOD


@rule(
    "INE002",
    "not-positive-definite",
    Severity.ERROR,
    help="take the tensor about the centre of mass anew, from the CAD program or from the shape",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    masses = subject.masses
    claimed = masses.diagnoses.get("INE002", ())
    yield from together((weighed, _finding(weighed, masses)) for weighed in claimed)


def _finding(weighed: LinkInertia, masses: Masses) -> Finding:
    low, *_, high = weighed.moments
    diagnosis = of_impossible(weighed, masses)
    return Finding(
        weighed.at,
        f"link '{weighed.link.name}' has principal moments of inertia of "
        f"{values(weighed.moments)}; all must be positive",
        str(diagnosis),
        replacement(weighed, diagnosis.tensor),
        weight=-low / max(abs(high), -low),
    )

"""A link that a joint moves has a mass, but no moment of inertia at all.

It can be turned without any effort: the equations of motion have no solution about that axis.
MuJoCo refuses the robot, other engines divide by zero or let the link spin and vanish. A tensor
full of zeros comes from an export that failed, or from a value with too few decimal places.
Compute it from mass and size.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    robotology/icub-models#269: https://github.com/robotology/icub-models/issues/269
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.inertials.diagnosis import as_solid, replacement
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.robot.inertials.link_comparison import LinkInertia
    from urdfkit.robot.inertials.masses import Masses
    from urdfkit.robot.model import Joint

BAD = """\
<link name="base"/>
<link name="arm">
  <collision>
    <geometry><cylinder radius="0.05" length="0.2"/></geometry>
  </collision>
  <inertial>
    <mass value="0.5"/>
    <inertia ixx="0" ixy="0" ixz="0" iyy="0" iyz="0" izz="0"/>
  </inertial>
</link>
<joint name="shoulder" type="continuous">
  <parent link="base"/>
  <child link="arm"/>
</joint>"""
GOOD = BAD.replace('ixx="0"', 'ixx="0.00197917"').replace(
    '"0" iyz="0" izz="0"', '"0.00197917" iyz="0" izz="0.000625"'
)
FIXED = GOOD


@rule(
    "INE005",
    "zero-inertia",
    Severity.ERROR,
    help="compute the tensor from mass and size: urdfkit explain XAC014 has the formulas",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    yield from together(_findings(subject.masses))


def _findings(masses: Masses) -> Iterator[tuple[LinkInertia, Finding]]:
    for body in masses.without_inertia:
        assert body.joint is not None
        for link, _ in body.links:
            if weighed := masses.by_name.get(link.name):
                yield weighed, _finding(weighed, body.joint)


def _finding(weighed: LinkInertia, joint: Joint) -> Finding:
    return Finding(
        weighed.at,
        f"link '{weighed.link.name}' of {weighed.mass:g} kg has no moment of inertia and is moved "
        f"by the {joint.kind} joint '{joint.name}'",
        as_solid(weighed) if weighed.is_measured else "",
        replacement(weighed, weighed.expected) if weighed.is_measured else None,
        weight=weighed.mass,
    )

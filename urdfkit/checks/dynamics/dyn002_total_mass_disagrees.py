"""Pinocchio finds another mass or centre of mass than the file states.

Asked for with `--target pinocchio`, as DYN001. Pinocchio drops an `<inertial>` in which a number
cannot be read and says so on the standard error of the C++ library only: the link is weightless,
and every torque that is computed with it is wrong.

Sources:
    Pinocchio, URDF model: https://github.com/stack-of-tasks/pinocchio/blob/devel/src/parsers/urdf/model.cpp
    urdfdom, link.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/link.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from math import dist
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.robot.inertia import combined
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

TARGETS = ("pinocchio",)
BAD = """\
<link name="base">
  <inertial>
    <origin xyz="0 0.1"/>
    <mass value="2"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>"""
GOOD = BAD.replace("0 0.1", "0 0 0.1")

#: Of the mass in kg and of the centre in m, relative to them.
_TOLERANCE = 1e-6


@rule(
    "DYN002",
    "total-mass-disagrees",
    Severity.WARNING,
    needs=(Need.MODEL, Need.DYNAMICS),
    help="correct the numbers in the <inertial> that it drops",
)
def check(subject: Subject) -> Iterator[Finding]:
    if "pinocchio" not in subject.targets.names or subject.is_part or not subject.tree.is_sound:
        return
    opinion = subject.opinion
    if opinion.refusal:
        return  # DYN001
    links = subject.model.links_by_name
    own = combined(properties_of(links[name], at) for name, at in subject.tree.frames.items())
    if abs(opinion.mass - own.mass) > _TOLERANCE * max(abs(own.mass), abs(opinion.mass)):
        reported = f"{opinion.mass:g} kg to Pinocchio, and {own.mass:g} kg as its links state"
    elif dist(opinion.center, own.center) > _TOLERANCE * max(1.0, *map(abs, own.center)):
        reported = "{} m to Pinocchio, and {} m as its links state".format(
            *(" ".join(f"{place:.4g}" for place in at) for at in (opinion.center, own.center))
        )
        reported = f"its centre of mass is at {reported}"
    else:
        return
    reason = f": {opinion.complaints[0]}" if opinion.complaints else ""
    yield Finding(subject.model.root, f"the robot weighs {reported}{reason}")

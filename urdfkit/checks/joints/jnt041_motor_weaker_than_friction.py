"""The friction or the damping of a joint holds it against its motor.

Friction that exceeds the effort of the joint never lets go: nothing the controller does moves it.
Damping takes more, the faster the joint turns; where all of the effort ends in it at less than a
tenth of a radian or a centimetre per second, and far below the velocity that the joint may have,
the joint creeps. Both are in N m (or N), and N m per rad/s: numbers of a data sheet in N mm, or
those that were found for another simulator, are a thousand times too large. Gazebo, MuJoCo and
Drake take them as they are.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    measured: of 1300 public descriptions one hand has it, with friction of 5 and effort of 0.7 N m.
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.joint_loads import effort
from urdfkit.robot.joints import MOVING, effort_unit, unit
from urdfkit.robot.model import Joint, number
from urdfkit.robot.samples import arm_xml
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Element

BAD = arm_xml(
    "revolute",
    '<limit lower="-2" upper="2" effort="10" velocity="3"/>',
    '<dynamics damping="0.1" friction="500"/>',
)
GOOD = BAD.replace('"500"', '"0.5"')

#: A joint that is driven with all its effort and moves more slowly creeps, in rad/s and m/s.
_CREEPS = {"rad": 0.1, "m": 0.01}

#: As a part of the velocity of the joint.
_SLOW = 0.05


@rule(Severity.WARNING, help="write friction in N m (N for a slide), damping in N m s/rad (N s/m)")
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        dynamics = joint.at.child("dynamics")
        most = effort(joint)
        if dynamics and most and joint.kind in MOVING and not joint.mimic:
            yield from _judged(joint, dynamics, most)


def _judged(joint: Joint, dynamics: Element, most: float) -> Findings:
    friction, damping = (number(dynamics.get(key)) or 0.0 for key in ("friction", "damping"))
    who, of = f"joint '{joint.name}'", effort_unit(joint)
    if friction > most:
        yield Finding(
            dynamics.attributes["friction"],
            f"{who}: its friction of {friction:g} {of} holds it against its effort of {most:g} "
            f"{of}, so that it never moves",
            weight=friction / most,
            alike="friction",
        )
    speed = joint.limit.velocity.value if joint.limit and joint.limit.velocity else 0.0
    reached = most / damping if damping > 0 else speed
    if reached < min(_CREEPS[unit(joint)], _SLOW * speed):
        yield Finding(
            dynamics.attributes["damping"],
            f"{who}: against a damping of {damping:g} {of} s/{unit(joint)} its effort of {most:g} "
            f"{of} makes no more than {reached:.2g} {unit(joint)}/s; its velocity is {speed:g}",
            weight=speed / reached,
            alike="damping",
        )

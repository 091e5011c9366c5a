"""The damping or the friction of a joint is negative.

Both take energy out of the motion, so a negative one puts energy in: in MuJoCo the joint moves
faster and faster by itself. Drake rejects a negative damping, Pinocchio a negative friction.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    Pinocchio, URDF model: https://github.com/stack-of-tasks/pinocchio/blob/devel/src/parsers/urdf/model.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.joints import effort_unit, unit
from urdfkit.robot.model import number
from urdfkit.robot.samples import arm_xml
from urdfkit.text.diagnostic import Severity

BAD = arm_xml("continuous", '<axis xyz="0 0 1"/>', '<dynamics damping="-0.1"/>')
GOOD = BAD.replace("-0.1", "0.1")


@rule(Severity.ERROR, help="write the positive amount, or 0 for none")
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        dynamics = joint.at.child("dynamics")
        if dynamics is None:
            continue
        effort = effort_unit(joint)
        for key, of in (("damping", f"{effort} s/{unit(joint)}"), ("friction", effort)):
            value = number(dynamics.get(key))
            if value is not None and value < 0:
                yield Finding(
                    dynamics.attributes[key],
                    f"joint '{joint.name}': the {key} is {value:g} {of}, below 0",
                )

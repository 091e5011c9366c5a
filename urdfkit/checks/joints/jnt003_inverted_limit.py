"""The lower limit of a joint is above its upper limit.

Nothing can lie between the two. Drake ends the program, Gazebo swaps them, MuJoCo and PyBullet
take the joint for unlimited, MoveIt and Pinocchio compute on with an empty range. PyBullet's own
robots write lower="1" upper="-1" for a free joint: a free revolute joint is `continuous` in URDF,
and a free prismatic one has limits that are far apart.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.joints import bounds, unit
from urdfkit.robot.model import Limit
from urdfkit.robot.samples import arm_xml
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import swap

BAD = arm_xml("revolute", '<limit lower="2.775" upper="-2.775" effort="30" velocity="1"/>')
GOOD = BAD.replace('lower="2.775" upper="-2.775"', 'lower="-2.775" upper="2.775"')
FIXED = GOOD

#: How robots made for PyBullet say that a joint is free.
_FREE_IN_PYBULLET = ((1.0, -1.0), (1.0, 0.0), (0.0, -1.0))


@rule(Severity.ERROR)
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        ends = bounds(joint)
        if ends is None or ends[0] <= ends[1]:
            continue
        assert joint.limit is not None
        lower, upper = ends
        message = f"joint '{joint.name}': lower limit {lower:g} {unit(joint)} is above upper limit "
        message += f"{upper:g} {unit(joint)}"
        for key in ("lower", "upper"):
            if key not in joint.limit.at.attributes:
                message += f" ({key} is not written, so it is 0)"
        if ends in _FREE_IN_PYBULLET:
            free = "make it continuous" if joint.kind == "revolute" else "set them far apart"
            yield Finding(joint.limit.at, message, f"swap them; if it is to be free, {free}")
        else:
            yield Finding(joint.limit.at, message, "swap them", _swapped(joint.limit))


def _swapped(limit: Limit) -> Fix | None:
    lower, upper = limit.at.attributes.get("lower"), limit.at.attributes.get("upper")
    if lower is None or upper is None:
        return None
    edits = swap(lower, upper)
    return Fix.of("swap lower and upper", edits)

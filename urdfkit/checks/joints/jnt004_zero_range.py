"""The lower and the upper limit of a joint are equal.

Readers disagree on what that means: MoveIt, Gazebo, Drake and Pinocchio hold the joint still,
MuJoCo lets it move without limit. Limits that are not written are 0 for urdfdom, so a revolute
joint with effort and velocity alone cannot turn either. A joint that never moves is fixed; one
that turns without end is continuous.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.joints import bounds, unit
from urdfkit.robot.model import Joint
from urdfkit.robot.samples import arm_xml
from urdfkit.text.diagnostic import Severity

BAD = arm_xml(
    "revolute", '<axis xyz="0 0 1"/>', '<limit lower="0" upper="0" effort="100" velocity="1"/>'
)
GOOD = BAD.replace('lower="0" upper="0"', 'lower="-0.5" upper="0.5"')


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        ends = bounds(joint)
        if ends is None or ends[0] != ends[1]:
            continue
        assert joint.limit is not None
        yield Finding(
            joint.limit.at,
            f"joint '{joint.name}' is {joint.kind} but cannot move: {_why(joint, ends[0])}",
            "set lower and upper"
            + (", make it continuous if it turns without end," if joint.kind == "revolute" else "")
            + " or make it fixed",
            alike="cannot move",
        )


def _why(joint: Joint, value: float) -> str:
    assert joint.limit is not None
    written = [key for key in ("lower", "upper") if key in joint.limit.at.attributes]
    if not written:
        return "lower and upper limit are not written, so both are 0"
    if len(written) == 1:
        return f"its {written[0]} limit is 0, and so is the one that is not written"
    return f"lower and upper limit are both {value:g} {unit(joint)}"

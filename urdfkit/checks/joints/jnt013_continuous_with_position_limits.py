"""A continuous joint has position limits.

A continuous joint turns without end. Gazebo, MoveIt, ros2_control, MuJoCo and Pinocchio ignore
`lower` and `upper`; Drake obeys them, so that the same robot moves differently there, and not at
all with 0 and 0. Remove them, or make the joint revolute if it has an end.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from __future__ import annotations

from urdfkit.lint.rules import Finding, Findings, Fix, Severity, Subject, rule
from urdfkit.robot.samples import arm_xml
from urdfkit.text.editing.edits import all_or_none, remove_attribute

BAD = arm_xml(
    "continuous",
    '<axis xyz="0 0 1"/>',
    '<limit lower="-6.28" upper="6.28" effort="9" velocity="6.28"/>',
)
FIXED = GOOD = BAD.replace('lower="-6.28" upper="6.28" ', "")


@rule(Severity.WARNING, help="remove lower and upper, or make the joint revolute")
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        if joint.kind != "continuous" or joint.limit is None:
            continue
        written = [
            attribute
            for name, attribute in joint.limit.at.attributes.items()
            if name in ("lower", "upper")
        ]
        if written:
            values = " and ".join(f'{attribute.name}="{attribute.value}"' for attribute in written)
            yield Finding(
                written[0],
                f"joint '{joint.name}' is continuous and has {values}, which only Drake obeys",
                fix=Fix.of("remove lower and upper", all_or_none(map(remove_attribute, written))),
                group_key="continuous",
            )

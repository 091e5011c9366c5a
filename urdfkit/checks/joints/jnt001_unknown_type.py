"""A joint has a type that URDF does not define.

The types are revolute, continuous, prismatic, fixed, floating and planar, in lower case. urdfdom,
and with it RViz, MoveIt, Gazebo and Pinocchio, rejects the whole robot; so does Drake. Only
PyBullet and MuJoCo support `spherical`: for other programs, write a ball joint as three revolute
joints in series, with links of almost no size between them. `spherical` is not reported if
PyBullet and MuJoCo are the only targets.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    PyBullet, UrdfParser.cpp: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/UrdfParser.cpp
"""

from urdfkit.core.suggest import TYPO, hint_for, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import arm_xml
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression
from urdfkit.text.schema import JOINT_TYPES

BAD = arm_xml("Revolute", '<limit lower="-1" upper="1" effort="10" velocity="1"/>')
FIXED = GOOD = BAD.replace("Revolute", "revolute")


@rule(Severity.ERROR, help=f"use one of {', '.join(JOINT_TYPES)}")
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        kind = joint.at.attributes.get("type")
        if kind is None or kind.value in JOINT_TYPES or is_expression(kind.value):
            continue
        if kind.value == "spherical" and context.targets.all_are("reads_ball_joints"):
            continue
        suggested = nearest(kind.value.strip(), JOINT_TYPES, TYPO)
        message = f"joint '{joint.name}': unknown type '{kind.value}'{hint_for(suggested)}"
        yield Finding(kind, message, fix=fix_value(kind, suggested))

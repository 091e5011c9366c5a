"""A movable joint has no axis and gets the default, x.

URDF's default is 1 0 0, and all parsers agree. Few joints turn about x: a missing y or z axis goes
unnoticed until the robot moves. Write the axis, also if it is x.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joints import MOVING
from urdfkit.robot.samples import arm_xml

BAD = arm_xml("continuous")
GOOD = BAD.replace("</joint>", '  <axis xyz="0 1 0"/>\n</joint>')

_MOTION = {"prismatic": "moves along", "planar": "moves in the plane across"}


@rule(Severity.INFO, help="write the axis, also if it is x")
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.kind in (*MOVING, "planar") and joint.at.child("axis") is None:
            motion = _MOTION.get(joint.kind, "turns about")
            yield Finding(
                joint.at, f"joint '{joint.name}' has no <axis>: it {motion} x (1 0 0) by default"
            )

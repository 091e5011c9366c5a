"""A link is the child of two joints.

URDF describes trees: every link is the child of one joint. MuJoCo rejects the robot, PyBullet
crashes, urdfdom (RViz, MoveIt, Gazebo) keeps both joints, and the frame of the link jumps between
two places. Usually one `<child>` is a mistake; for a closed mechanism, omit one joint and close the
loop in the simulator, as TRE003 explains.

Sources:
    URDF, robot: https://wiki.ros.org/urdf/XML/robot
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
"""

from collections import Counter

from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml

BAD = robot_xml(
    link_xml("base"),
    link_xml("arm"),
    link_xml("hand"),
    joint_xml("fixed"),
    joint_xml("fixed", name="wrist", parent="arm", child="hand"),
    joint_xml("fixed", name="mount", child="hand"),
)
GOOD = BAD[: BAD.index('\n<joint name="mount"')]


@rule(
    Severity.ERROR,
    help="keep one joint for each child, and close a closed mechanism in the simulator: urdfkit "
    "explain TRE003",
)
def check(context: Context) -> Findings:
    count = Counter(link.name for link in context.model.links)
    for name, joints in context.tree.parents.items():
        for joint in joints[1:]:
            first = joints[0]
            if joint.name == first.name or count[name] > 1:
                continue  # NAM001 reports duplicate joints and links
            yield Finding(
                joint.child or joint.at,
                f"link '{name}' is the child of joint '{joint.name}' and of joint '{first.name}'",
                related=(Related(first.at.span, f"joint '{first.name}'"),),
            )

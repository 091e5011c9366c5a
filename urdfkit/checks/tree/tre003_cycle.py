"""Joints form a closed loop, or one joint has the same link as parent and child.

URDF describes trees. urdfdom searches forever for the root of a loop, or drops a loop that has no
parent without a message; sdformat, MuJoCo, Drake and PyBullet reject it, Pinocchio crashes. Write a
closed mechanism as a tree: omit one joint of the loop, preferably a passive one, and close the loop
in the simulator. MuJoCo closes it with `<connect>` or `<weld>` in `<equality>`, PyBullet with
`createConstraint`, Drake with `<drake:linear_bushing_rpy>`, Gazebo Classic with a `<joint>` of SDF
within `<gazebo>`; RViz and MoveIt show the tree alone. The child of a joint is the link that moves.
A loop through a link that is defined twice is a consequence of NAM001.

Sources:
    URDF, robot: https://wiki.ros.org/urdf/XML/robot
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
"""

from collections import Counter

from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.samples import joint_xml, link_xml, robot_xml

BAD = robot_xml(
    link_xml("base"),
    link_xml("crank"),
    link_xml("rod"),
    joint_xml("continuous", name="pivot", parent="rod", child="crank"),
    joint_xml("continuous", name="pin", parent="crank", child="rod"),
)
GOOD = BAD.replace('<parent link="rod"/>', '<parent link="base"/>')

#: Number of links of a loop that a message lists; the others are counted.
MAX_NAMED = 8


@rule(
    Severity.ERROR,
    help="leave a passive joint of the loop out, and close it in the simulator: urdfkit explain "
    "TRE003",
)
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.parent_name and joint.parent_name == joint.child_name:
            message = f"joint '{joint.name}' has link '{joint.child_name}' as parent and as child"
            yield Finding(
                joint.child or joint.at, message, "name the link that this joint moves as its child"
            )
    counts = Counter(link.name for link in context.model.links)
    for loop in context.tree.cycles:
        if any(counts[joint.parent_name] > 1 for joint in loop):
            continue
        yield Finding(
            loop[-1].child or loop[-1].at,
            f"a closed loop of {len(loop)} joints: {_shown(loop)}",
            related=tuple(
                Related(joint.at.span, f"joint '{joint.name}'") for joint in loop[:-1][:MAX_NAMED]
            ),
        )


def _shown(loop: tuple[Joint, ...]) -> str:
    """The links of a loop, such as ``a -> b -> a``."""
    names = [joint.parent_name for joint in loop]
    more = [f"({len(names) - MAX_NAMED} more)"] if len(names) > MAX_NAMED else []
    return " -> ".join([*names[:MAX_NAMED], *more, names[0]])

"""A joint is floating or planar.

Few programs support these types. Gazebo drops the joint: the link and its children become a
separate body, which falls. KDL, and with it robot_state_publisher, reads both types as fixed. Drake
makes a floating link a free body. MuJoCo, Pinocchio and MoveIt support both, but Pinocchio and
MoveIt move a planar joint perpendicular to z, ignoring its axis. All programs support two prismatic
joints and a revolute one as a replacement for a planar joint; a robot that moves freely needs no
joint at its root.

Sources:
    kdl_parser: https://github.com/ros/kdl_parser/blob/noetic-devel/kdl_parser/src/kdl_parser.cpp
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    MoveIt, planar_joint_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/planar_joint_model.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import arm_xml, link_xml
from urdfkit.ros.targets import GAZEBO

BAD = arm_xml("planar", '<axis xyz="0 0 1"/>')
GOOD = link_xml("base")


@rule(
    Severity.INFO,
    help="remove it if the robot is to move freely, or use prismatic and revolute joints",
    by_target=dict.fromkeys(GAZEBO, Severity.WARNING),
)
def check(context: Context) -> Findings:
    for joint in context.model.joints:
        if joint.kind in ("floating", "planar") and joint.type:
            yield Finding(
                joint.type,
                f"joint '{joint.name}' is {joint.kind}: Gazebo drops the joint, and KDL reads it "
                "as fixed",
            )

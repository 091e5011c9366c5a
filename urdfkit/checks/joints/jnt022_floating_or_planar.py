"""A joint is floating or planar.

Few readers can do it. Gazebo makes no joint of it at all: the link and its child links become a
body of their own, which falls, and a planar joint keeps nothing in its plane. KDL, and with it
robot_state_publisher, takes both for fixed. Drake sets a floating link free. MuJoCo, Pinocchio and
MoveIt understand both, but the last two move a planar joint across z, whatever its axis. Three
prismatic and revolute joints in a row say planar foreveryone; a robot that may go anywhere needs
no joint at its root.

Sources:
    kdl_parser: https://github.com/ros/kdl_parser/blob/noetic-devel/kdl_parser/src/kdl_parser.cpp
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    MoveIt, planar_joint_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/planar_joint_model.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.samples import arm_xml, link_xml
from urdfkit.ros.targets import GAZEBO
from urdfkit.text.diagnostic import Severity

BAD = arm_xml("planar", '<axis xyz="0 0 1"/>')
GOOD = link_xml("base")


@rule(
    Severity.INFO,
    help="leave the joint out where it only sets the robot free, or build it of single joints",
    by_target=dict.fromkeys((*GAZEBO, "kdl"), Severity.WARNING),
)
def check(subject: Subject) -> Findings:
    for joint in subject.model.joints:
        if joint.kind in ("floating", "planar") and joint.type:
            yield Finding(
                joint.type,
                f"joint '{joint.name}' is {joint.kind}: Gazebo makes no joint of it, and KDL a "
                "fixed one",
            )

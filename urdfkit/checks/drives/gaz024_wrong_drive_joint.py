"""A drive plugin drives a joint that is not a wheel, or refers to one joint for two wheels.

A drive sets a velocity and expects the joint to turn without end: a revolute joint stops at its
limits, and a prismatic joint slides. Make the wheel's joint `continuous`. If two parameters refer
to the same joint, the other wheel is not driven: the robot drags it, turns instead of driving
straight, and its odometry is wrong. Usually a line was copied and not changed.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    gz-sim, DiffDrive.cc: https://github.com/gazebosim/gz-sim/blob/main/src/systems/diff_drive/DiffDrive.cc
    gazebo_plugins, skid steer: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_skid_steer_drive.cpp
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import bounds
from urdfkit.ros.gazebo.drives import drive_of, driven
from urdfkit.ros.gazebo.plugins import Reference
from urdfkit.ros.gazebo.samples import WHEELED, gazebo_xml, plugin_xml

GOOD = WHEELED + gazebo_xml(
    plugin_xml(
        "drive",
        "libgazebo_ros_diff_drive.so",
        "<leftJoint>left_joint</leftJoint>",
        "<rightJoint>right_joint</rightJoint>",
    )
)
BAD = GOOD.replace("continuous", "revolute").replace(
    "</joint>", '  <limit lower="-3" upper="3" effort="10" velocity="10"/>\n</joint>'
)

#: Range in rad from which the limits of a revolute joint are only formal.
ENDLESS = 1e4


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    for use in context.plugins:
        if drive_of(use) is None:
            continue
        first: dict[str, Reference] = {}
        for reference in driven(use):
            at, name = reference.item.at, reference.parameter.name
            joint = context.model.joints_by_name.get(reference.name)
            other = first.setdefault(reference.name, reference)
            if other is not reference and other.parameter.name != name:
                yield Finding(
                    at,
                    f"{use.title}: <{name}> and <{other.parameter.name}> both name "
                    f"'{reference.name}'",
                    "name the joint of the other wheel",
                    related=(Related(other.item.at.span, "also named here"),),
                )
            elif joint and "steer" not in name.lower() and _has_ends(joint):
                yield Finding(
                    at,
                    f"{use.title} drives joint '{joint.name}' as a wheel, but it is {joint.kind}",
                    "make the joint continuous, or name the joint of the wheel",
                )


def _has_ends(joint: Joint) -> bool:
    """True if a joint cannot turn without end, as a wheel does."""
    ends = bounds(joint)
    if joint.kind == "revolute" and ends:
        return ends[1] - ends[0] <= ENDLESS
    return joint.kind in ("revolute", "prismatic", "floating", "planar")

"""Joints mimic others in a program that does not support mimic.

RViz, MoveIt, Drake and MuJoCo 4 couple the joints. Gazebo Classic and Fortress ignore `<mimic>`:
the followers swing freely. From Harmonic on, only the physics engine bullet-featherstone couples
them; the default engine warns once and does not couple them. The control plugin moves a follower
that is listed in `<ros2_control>`, and for Classic there are mimic plugins. A follower is not
reported if a plugin of your own names it and the joint that it mimics, or if `<ros2_control>` is
that of the real robot. KDL treats a follower
as an independent joint, and so does Pinocchio unless mimic joints are enabled.

Sources:
    gz-sim, Physics.cc: https://github.com/gazebosim/gz-sim/blob/main/src/systems/physics/Physics.cc
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    Pinocchio, URDF joints: https://github.com/stack-of-tasks/pinocchio/blob/devel/include/pinocchio/parsers/urdf/model.hxx
    ros-simulation/gazebo_ros_pkgs#251: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/251
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint_limits import related, several
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import hand_xml, inertial_xml, robot_xml
from urdfkit.ros.catalog.plugins import find
from urdfkit.ros.ros_control import has_no_simulated_hardware
from urdfkit.ros.targets import CLASSIC, GAZEBO

_LIMIT = '<limit lower="0" upper="0.04" effort="20" velocity="0.2"/>'
_INERTIAL = inertial_xml("0.015", "2.4e-6 2.4e-6 7.5e-7")
BAD = robot_xml(
    hand_xml("prismatic", [_LIMIT], [_LIMIT, '<mimic joint="left_joint"/>'], _INERTIAL),
    '<gazebo>\n  <plugin name="control" filename="libgazebo_ros_control.so"/>\n</gazebo>',
)
_PLUGIN = """\
  <plugin name="fingers" filename="libroboticsgroup_gazebo_mimic_joint_plugin.so">
    <joint>left_joint</joint>
    <mimicJoint>right_joint</mimicJoint>
  </plugin>
"""
GOOD = BAD.replace("</gazebo>", f"{_PLUGIN}</gazebo>")


@rule(
    Severity.INFO,
    help="list the joints in <ros2_control>, or use the physics engine bullet-featherstone",
    by_target=dict.fromkeys(GAZEBO, Severity.WARNING),
)
def check(context: Context) -> Findings:
    """One finding for all joints: a hand has a dozen mimic joints."""
    if not context.targets.any_of(GAZEBO) or has_no_simulated_hardware(context.model):
        return
    coupled = _coupled(context.model)
    joints = [
        joint
        for joint in context.model.joints
        if joint.mimic and joint.is_single_dof and joint.name not in coupled
    ]
    if joints and joints[0].mimic:
        yield Finding(
            joints[0].mimic.at,
            f"{several(joints)}: Gazebo does not enforce the <mimic>",
            _help(context),
            related=related((joint, joint.mimic.at.span) for joint in joints if joint.mimic),
        )


def _help(context: Context) -> str:
    """Help for Gazebo Classic, which has mimic plugins; empty for the default help."""
    classic = context.targets.among(CLASSIC)
    if not classic:
        return ""
    by_control = "" if "classic-ros1" in classic else ", or list the joints in <ros2_control>"
    return "add a mimic plugin" + by_control


def _coupled(model: RobotModel) -> set[str]:
    """The joints that a control plugin, a transmission or another plugin couples."""
    names = {
        element.get("name") or ""
        for owner in (*model.ros2_controls, *model.transmissions)
        for element in owner.children
        if element.tag.endswith("joint")  # passive_joint, gap_joint, ...
    }
    for block in model.gazebo:
        for plugin in block.all("plugin"):
            filename = plugin.get("filename") or ""
            named = {element.text.strip() for element in plugin.walk()}
            if "mimic" in filename:
                names |= named
            elif not find(filename):  # a library of its own, such as the differential of a rover
                names.update(
                    joint.name
                    for joint in model.joints
                    if joint.mimic and {joint.name, joint.leader} <= named
                )
    return names

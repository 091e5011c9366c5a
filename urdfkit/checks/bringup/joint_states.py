"""Joints whose states nothing publishes, so that their links have no transform."""

import re

from urdfkit.checks.bringup.defined_controllers import defined_controllers
from urdfkit.checks.bringup.gz_bridges import bridges_of_gz
from urdfkit.checks.bringup.workspace_launches import is_included
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings
from urdfkit.robot.joint_limits import can_move
from urdfkit.robot.model import RobotModel
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.ros_control import control_plugins

_PUBLISHER = "robot_state_publisher"
_JOINT_STATES = ("joint_state_publisher", "joint_state_publisher_gui")
#: Packages whose programs publish no joint states, and no transforms of the links of joints.
_STATELESS = re.compile(
    r"robot_state_publisher|ros_gz_(sim|bridge|image)|rviz2|tf2_ros|robot_localization"
    r"|slam_toolbox|joy|twist_mux|teleop_twist_(joy|keyboard)|nav2_\w+"
)
#: Systems of gz-sim: one publishes joint states, the other the poses of links.
_STATES, _POSES = "joint-state-publisher", "pose-publisher"
_MAX_NAMED = 2


def missing_broadcaster(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Controllers and robot_state_publisher without a publisher of joint states."""
    if not any(node.package == _PUBLISHER for node in programs):
        return
    spawned = list(spawned_controllers(programs))
    defined = defined_controllers(context)
    types = {name: defined[name].type for name in defined if defined[name].ros == 2}
    known = [types.get(controller.name, "") for controller in spawned]
    bridged = (topic for node in programs for topic in bridged_topics(node, context.resolver))
    if (
        not all(known)
        or any(kind.endswith("JointStateBroadcaster") for kind in known)
        or any(node.package in _JOINT_STATES for node in programs)
        or any(topic.ros_type.endswith("/JointState") for topic in bridged)
    ):
        return
    if spawned and not _is_rigid(context):
        yield Finding(
            spawned[0].at,
            "nothing publishes the joint states: no joint_state_broadcaster is started",
            "spawn joint_state_broadcaster, too, and define it in the YAML file of the controllers",
        )


def _is_rigid(context: Context) -> bool:
    """True if the launch file starts robots, such as a sensor, of which no joint moves."""
    models = [robot.model for _, robot in context.described_robots]
    return bool(models) and not any(can_move(joint) for model in models for joint in model.joints)


def unpublished_joint_states(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A robot of gz-sim in RViz whose joints have no states, so that links have no transform."""
    publisher = next((node for node in programs if node.package == _PUBLISHER), None)
    packages = {node.package for node in programs}
    bridges = bridges_of_gz(programs)
    if publisher is None or "rviz2" not in packages or not bridges:
        return
    bridged = (topic for node in bridges for topic in bridged_topics(node, context.resolver))
    has_states = any(topic.ros_type.endswith("/JointState") for topic in bridged)
    if has_states or not all(map(_STATELESS.fullmatch, packages)):
        return
    if is_included(context):
        return
    for description, robot in context.described_robots:
        systems = _systems(robot.model)
        joints = [joint.name for joint in robot.model.joints if joint.degrees_of_freedom == 1]
        is_posed = any(_POSES in system for system in systems) or control_plugins(robot.model)
        if joints and not is_posed and description.is_whole:
            help = "bridge its topic as sensor_msgs/msg/JointState to /joint_states"
            if not any(_STATES in system for system in systems):
                help = f"add gz-sim-{_STATES}-system to the robot, and {help}"
            yield Finding(
                publisher.at,
                f"nothing publishes the states of {few(joints, _MAX_NAMED)}: RViz has no "
                "transform of their links",
                help,
            )


def _systems(model: RobotModel) -> list[str]:
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    return [plugin.get("filename") or "" for plugin in plugins]

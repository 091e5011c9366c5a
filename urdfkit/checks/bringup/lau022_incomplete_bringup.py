"""Controllers, or the node that publishes the robot, wait for what the launch file does not start.

- Controllers and robot_state_publisher are started, but no publisher of joint states: the links
  of moving joints have no transform, and RViz shows them at the origin. Spawn
  `joint_state_broadcaster`. A robot without moving joints, such as a sensor, needs none. Or the
  broadcaster, or the system of Gazebo whose states are bridged, has a list of joints without some
  that another controller moves.
- `ros2_control_node` has no parameter file, so the types of the controllers are unknown.
- No robot_state_publisher publishes on the topic of `create -topic`: "Waiting messages on topic
  [robot_description]", for ever.
- `ros2_control_node` reads the robot from a topic that no robot_state_publisher publishes. Since
  Jazzy that is so even if it gets the robot as a parameter.
- A spawner looks for the controller manager in another namespace, or under another name: "Could not
  contact service /controller_manager/list_controllers". A relative name is in the namespace of the
  spawner; in ROS 1 the manager is in the `<robotNamespace>` of gazebo_ros_control.
- Nothing starts a controller manager: the robot that is spawned in Gazebo has no control plugin, as
  with other arguments of its description.

A launch file is not checked if it includes unavailable files that are not part of ROS.

Sources:
    ros2_control, joint_state_broadcaster: https://control.ros.org/rolling/doc/ros2_controllers/joint_state_broadcaster/doc/userdoc.html
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    ros2_control, spawner.py: https://github.com/ros-controls/ros2_control/blob/master/controller_manager/controller_manager/spawner.py
"""

import re
from collections.abc import Iterable

from urdfkit.checks.bringup.defined_controllers import defined_controllers
from urdfkit.checks.bringup.gz_bridges import bridges_of_gz
from urdfkit.checks.bringup.known_programs import (
    are_topics_known,
    known_programs,
    programs_of_robot,
)
from urdfkit.checks.bringup.mismatched_names import (
    manager_in_another_namespace,
    missing_description,
    missing_manager,
    unpublished_description,
    unread_description,
    untyped_controllers,
)
from urdfkit.checks.bringup.workspace_launches import is_included
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.joint_limits import can_move
from urdfkit.robot.model import RobotModel
from urdfkit.ros.claims import commanded_joints
from urdfkit.ros.controllers import Controller
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.launch.spawning import model_spawner
from urdfkit.ros.ros_control import control_plugins
from urdfkit.text.document import Element

NAME = "launch/robot.launch.xml"
BAD = """\
<launch>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description" value="&lt;robot/>"/>
  </node>
  <node pkg="controller_manager" exec="ros2_control_node">
    <param from="$(dirname)/control.yaml"/>
  </node>
  <node pkg="controller_manager" exec="spawner" args="arm"/>
</launch>
"""
GOOD = BAD.replace('args="arm"', 'args="joints arm"')
FILES = {
    "launch/control.yaml": b"""\
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    joints: {type: joint_state_broadcaster/JointStateBroadcaster}
""",
    "package.xml": b"<package><name>arm</name></package>",
}

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
#: The parameter with which move_group publishes the robot.
_PUBLISHING = re.compile(rb"publish_robot_description(?!_semantic)")


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    programs, of_robot = known_programs(context), programs_of_robot(context)
    yield from _missing_broadcaster(context, of_robot)
    yield from untyped_controllers(programs)
    describing = programs or (() if any(map(_may_describe, of_robot)) else of_robot)
    if describing and are_topics_known(context):
        yield from unpublished_description(context, describing)
        yield from unread_description(describing)
    if programs and are_topics_known(context):
        yield from missing_description(context, programs)
        yield from _unpublished_joint_states(context, programs)
    if of_robot and are_topics_known(context):
        yield from manager_in_another_namespace(context, of_robot)
        yield from missing_manager(context, of_robot)


def _may_describe(program: StartedProgram) -> bool:
    """True for a move_group that may publish the robot, too."""
    is_move_group = program.package == "moveit_ros_move_group"
    return is_move_group and _PUBLISHING.search(program.span.source.data) is not None


def _missing_broadcaster(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Controllers and robot_state_publisher without a publisher of joint states."""
    if not any(node.package == _PUBLISHER for node in programs):
        return
    spawned = list(spawned_controllers(programs))
    defined = defined_controllers(context)
    named = [defined.get(controller.name) for controller in spawned]
    known = [controller for controller in named if controller and controller.ros == 2]
    if len(known) < len(named) or any(_publishes_joint_states(node, programs) for node in programs):
        return
    is_bridged = _bridges_joint_states(context, programs)
    if broadcasters := [one for one in known if one.type.endswith("JointStateBroadcaster")]:
        if len(broadcasters) == 1 and not is_bridged:
            yield from _unlisted_joints(context, broadcasters[0], known)
        return
    running = [controller for controller in spawned if controller.program.is_sure]
    lost = _unbridged_joints(context, known) if is_bridged else []
    if running and (lost if is_bridged else not _is_rigid(context)):
        of_joints = f"states of {few(lost, _MAX_NAMED)}" if lost else "joint states"
        yield Finding(
            running[0].at,
            f"nothing publishes the {of_joints}: no joint_state_broadcaster is started",
            "spawn joint_state_broadcaster, too, and define it in the YAML file of the controllers",
        )


def _publishes_joint_states(node: StartedProgram, programs: tuple[StartedProgram, ...]) -> bool:
    """True for a joint_state_publisher; with Gazebo, an optional one is for other uses."""
    is_optional = not node.is_sure and any(map(model_spawner, programs))
    return node.package in _JOINT_STATES and not is_optional


def _unlisted_joints(
    context: Context, broadcaster: Controller, controllers: list[Controller]
) -> Findings:
    """Joints of the robot that another controller moves, and the only broadcaster leaves out.

    It reads its list only if it has one of interfaces, too.
    """
    listed = broadcaster.values(["joints"])
    if not listed or not broadcaster.values(["interfaces"]):
        return
    names = {value.text for value in broadcaster.values(["joints", "extra_joints"])}
    if lost := _moved_joints(context, controllers, names):
        yield Finding(
            listed[0].span,
            f"'{broadcaster.name}' does not publish the states of {few(lost, _MAX_NAMED)}, which a "
            "controller moves: their links have no transform",
            "add them to joints, or remove the list: then it publishes all",
        )


def _unbridged_joints(context: Context, controllers: list[Controller]) -> list[str]:
    """Joints that a controller moves, and whose states Gazebo's system leaves out."""
    names: set[str] = set()
    for _, robot in context.described_robots:
        for plugin in _plugins(robot.model):
            listed = [joint.text.strip() for joint in plugin.all("joint_name")]
            if _STATES in (plugin.get("filename") or "") and not listed:
                return []  # it publishes all
            names.update(listed)
    return _moved_joints(context, controllers, names) if names else []


def _moved_joints(
    context: Context, controllers: list[Controller], published: set[str]
) -> list[str]:
    """Joints of the robot that a controller moves, without those whose states are published."""
    robots = [robot.model for _, robot in context.described_robots]
    moving = {joint.name for model in robots for joint in model.joints if can_move(joint)}
    commanded = (value.text for one in controllers for value in commanded_joints(one))
    return [name for name in dict.fromkeys(commanded) if name in moving - published]


def _is_rigid(context: Context) -> bool:
    """True if the launch file starts robots, such as a sensor, of which no joint moves."""
    models = [robot.model for _, robot in context.described_robots]
    return bool(models) and not any(can_move(joint) for model in models for joint in model.joints)


def _bridges_joint_states(context: Context, programs: Iterable[StartedProgram]) -> bool:
    bridged = (topic for node in programs for topic in bridged_topics(node, context.resolver))
    return any(topic.ros_type.endswith("/JointState") for topic in bridged)


def _unpublished_joint_states(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A robot of gz-sim in RViz whose joints have no states, so that links have no transform."""
    publisher = next((node for node in programs if node.package == _PUBLISHER), None)
    packages = {node.package for node in programs if node.is_sure}
    bridges = bridges_of_gz(programs)
    if publisher is None or "rviz2" not in packages or not bridges:
        return
    # Controllers may have a condition; sliders with one are for other uses.
    packages |= {node.package for node in programs if node.package not in _JOINT_STATES}
    has_states = _bridges_joint_states(context, bridges)
    if has_states or not all(map(_STATELESS.fullmatch, packages)) or is_included(context):
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
    return [plugin.get("filename") or "" for plugin in _plugins(model)]


def _plugins(model: RobotModel) -> list[Element]:
    return [plugin for block in model.gazebo for plugin in block.all("plugin")]

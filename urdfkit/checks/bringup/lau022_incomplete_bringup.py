"""A program of a launch file waits for something that the launch file does not start.

- Controllers and robot_state_publisher are started, but no publisher of joint states: the links
  of moving joints have no transform, and RViz shows them at the origin. Spawn
  `joint_state_broadcaster`. A robot without moving joints, such as a sensor, needs none.
- A filter or a planner uses the wall clock, while Gazebo and other nodes use simulation time
  (`use_sim_time`): its transforms are years newer than the data. An info for
  robot_state_publisher, which keeps the stamps of the joint states.
- Nodes use `use_sim_time`, but no bridge forwards Gazebo's `/clock`: their time stays zero. Or the
  controller manager of a robot that is not simulated uses it.
- `ros2_control_node` has no parameter file, so the types of the controllers are unknown.
- Controllers are spawned in a gz sim that is started without `-r`: the simulation is paused, and
  no controller becomes active. An info without controllers.
- The `<ros2_control>` of a robot in Gazebo is `mock_components/GenericSystem`, which Gazebo's
  plugin does not load, or that of the real robot, although its files also name that of Gazebo. Or
  `ros2_control_node` runs hardware of Gazebo, but no robot is spawned in Gazebo: "class
  gz_ros2_control/GazeboSimSystem does not exist".
- No robot_state_publisher publishes on the topic of `create -topic`: "Waiting messages on topic
  [robot_description]", for ever.
- `ros2_control_node` reads the robot from a topic that no robot_state_publisher publishes. Since
  Jazzy that is so even if it gets the robot as a parameter.
- A spawner looks for the controller manager in another namespace, or under another name: "Could not
  contact service /controller_manager/list_controllers". A relative name is in the namespace of the
  spawner; in ROS 1 the manager is in the `<robotNamespace>` of gazebo_ros_control.
- A filter, a costmap or all displays of RViz read odometry, an IMU, images or a scan from a topic
  that nothing publishes, while such messages are published on another topic. Reported only if all
  programs of the workspace, and the publishers of the robot in RViz, are known.
- Such a topic is published in Gazebo by a sensor of the robot, but no bridge forwards it.
- The mask of a filter, or its `filter_info_topic`, is on another topic than its server says.
- robot_localization and the controller of the wheels both leave the transform from odometry to the
  robot to the other one.
- Nothing reads the velocity commands of twist_mux, Nav2 or a teleoperation node, while a drive
  reads them on another topic. Reported only if all programs of the workspace are known.
- A teleoperation node, or Nav2, publishes `Twist` on the topic of a drive that reads
  `TwistStamped`, as those of ros2_control do: no message arrives, without an error.
- A lifecycle manager of Nav2 waits for a node that nothing starts, or `autostart` of the manager is
  false, as it is by default. Or no manager activates a node of Nav2, or of slam_toolbox since
  Jazzy, which stays unconfigured.
  Or no launch file of the workspace starts a lifecycle manager for a server of Nav2.
- A launch file of Nav2 waits for a container of composable nodes that nothing starts.
- The collision monitor of Nav2 reads commands on another topic than that of the velocity smoother.

A launch file is not checked if it includes unavailable files that are not part of ROS.

Sources:
    ros2_control, joint_state_broadcaster: https://control.ros.org/rolling/doc/ros2_controllers/joint_state_broadcaster/doc/userdoc.html
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    ros2_control, spawner.py: https://github.com/ros-controls/ros2_control/blob/master/controller_manager/controller_manager/spawner.py
    ros-controls/gz_ros2_control#474: https://github.com/ros-controls/gz_ros2_control/issues/474
    ros-controls/gz_ros2_control#720: https://github.com/ros-controls/gz_ros2_control/issues/720
    Ekumen-OS/andino_gz#39: https://github.com/Ekumen-OS/andino_gz/issues/39
    turtlebot/turtlebot4#571: https://github.com/turtlebot/turtlebot4/issues/571
    Nav2, lifecycle manager: https://docs.nav2.org/configuration/packages/configuring-lifecycle.html
    ROS 2, clock and time: https://design.ros2.org/articles/clock_and_time.html
"""

from urdfkit.checks.bringup import lifecycle, mismatched_names, simulation
from urdfkit.checks.bringup.containers import missing_container
from urdfkit.checks.bringup.defined_controllers import defined_controllers
from urdfkit.checks.bringup.navigation_commands import mistyped_navigation, unpublished_commands
from urdfkit.checks.bringup.unpublished_odometry import unpublished_odometry
from urdfkit.checks.bringup.unpublished_topics import unpublished_inputs
from urdfkit.checks.bringup.unread_commands import (
    is_part_of_ros,
    mistyped_commands,
    unread_commands,
)
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.joint_limits import can_move
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.workspace.ros_packages import comes_with_ros

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


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from lifecycle.not_activated(context)
    yield from lifecycle.unmanaged(context)
    yield from lifecycle.not_started(context)
    yield from lifecycle.inactive_mapping(context)
    launch = context.launch
    programs = launch.programs
    if not _is_whole(launch) or not all(node.is_sure for node in programs):
        return
    if any(node.package == _PUBLISHER for node in programs):
        yield from _without_joint_states(context, programs)
    yield from mismatched_names.untyped_controllers(programs)
    yield from simulation.wall_clock_nodes(context, programs)
    yield from simulation.missing_clock(context, programs)
    yield from simulation.stopped_controllers(context, programs)
    yield from simulation.paused(context, programs)
    yield from simulation.unloaded_hardware(context, programs)
    yield from simulation.hardware_without_simulator(context, programs)
    if not launch.has_scopes and all(map(is_part_of_ros, launch.unread)):
        yield from missing_container(context)
        yield from mismatched_names.unpublished_description(context, programs)
        yield from mismatched_names.unread_description(programs)
        yield from mismatched_names.missing_description(context, programs)
        yield from simulation.unpublished_joint_states(context, programs)
        yield from unpublished_inputs(context)
        yield from unread_commands(context)
        yield from unpublished_odometry(context)
        yield from mistyped_commands(context, programs)
        yield from mistyped_navigation(context, programs)
        yield from unpublished_commands(context)
        yield from mismatched_names.manager_in_another_namespace(context, programs)


def _is_whole(launch: Launch) -> bool:
    """True if all referenced packages and files exist, or are part of ROS."""
    known = {name.partition("/")[0] for name in data("nodes")["publishers"]}
    packages = (
        item.searched is None or comes_with_ros(item.name) or item.name in known
        for item in launch.packages
    )
    files = (item.exists or item.path.startswith(f"{UNKNOWN}/") for item in launch.files)
    return all(packages) and all(files)


def _without_joint_states(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
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

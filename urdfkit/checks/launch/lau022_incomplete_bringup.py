"""What a launch file starts waits for something that it does not start.

- Controllers and a robot_state_publisher, but nothing that publishes the joint states: the links
  behind moving joints have no transform, and RViz shows them at the origin. Spawn
  `joint_state_broadcaster`.
- A filter or a planner by the wall clock, with Gazebo and nodes with `use_sim_time`: its transforms
  are years newer than their data. A robot_state_publisher is an info: it passes on the stamps of
  the joint states.
- Nodes with `use_sim_time`, and no bridge that passes Gazebo's `/clock` on: their time stands still
  at zero.
- A `ros2_control_node` without a parameter file, whose spawners know no type of their controllers.
- Controllers in a gz sim that is started without `-r`: it waits for its button to be pressed, and
  the spawners for the controllers to become active. Without controllers it is an info.
- A robot in Gazebo whose `<ros2_control>` is `mock_components/GenericSystem`: Gazebo's plugin does
  not load it. Or `ros2_control_node` for hardware of Gazebo, where no robot is put into Gazebo:
  "class gz_ros2_control/GazeboSimSystem does not exist".
- `create -topic` on which no robot_state_publisher publishes the robot: "Waiting messages on topic
  [robot_description]", for ever.
- A spawner that looks for the controller manager in another namespace: "Could not contact service
  /controller_manager/list_controllers". A relative name is in the namespace of the spawner; in
  ROS 1 the manager is in the `<robotNamespace>` of gazebo_ros_control.
- A filter, a costmap or all displays of RViz that read odometry, an IMU, images or a scan from a
  topic that nothing publishes, while such messages are published under another name. All that the
  workspace starts must be known. So must be the publishers of the robot that RViz shows.
- twist_mux or a node for teleoperation whose velocity commands nothing reads, while a drive reads
  them on another topic; all that the workspace starts must be known.

A file is left out that includes what is not at hand, unless that is part of ROS.

Sources:
    ros2_control, joint_state_broadcaster: https://control.ros.org/rolling/doc/ros2_controllers/joint_state_broadcaster/doc/userdoc.html
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    ros2_control, spawner.py: https://github.com/ros-controls/ros2_control/blob/master/controller_manager/controller_manager/spawner.py
    ros-controls/gz_ros2_control#720: https://github.com/ros-controls/gz_ros2_control/issues/720
    turtlebot/turtlebot4#571: https://github.com/turtlebot/turtlebot4/issues/571
    ROS 2, clock and time: https://design.ros2.org/articles/clock_and_time.html
"""

from urdfkit.checks.launch.defined_controllers import defined_controllers
from urdfkit.checks.launch.meeting_points import (
    other_manager,
    unpublished_description,
    without_types,
)
from urdfkit.checks.launch.simulated_hardware import mock_hardware, without_simulator
from urdfkit.checks.launch.simulated_time import by_wall_clock, paused, without_clock
from urdfkit.checks.launch.unpublished_topics import unpublished_inputs
from urdfkit.checks.launch.unread_commands import is_of_ros, unread_commands
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.spawned_controllers import controllers
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
    launch = context.launch
    started = (*launch.started, *launch.included)
    if not _is_whole(launch) or not all(one.is_sure for one in started):
        return
    if any(one.package == _PUBLISHER for one in started):
        yield from _without_joint_states(context, started)
    yield from without_types(started)
    yield from by_wall_clock(context, started)
    yield from without_clock(context, started)
    yield from paused(context, started)
    yield from mock_hardware(context, started)
    yield from without_simulator(context, started)
    if not launch.has_scopes and all(map(is_of_ros, launch.unread)):
        yield from unpublished_description(context, started)
        yield from unpublished_inputs(context)
        yield from unread_commands(context, started)
        yield from other_manager(context, started)


def _is_whole(launch: Launch) -> bool:
    """True if all is known that is started, but for what is part of ROS."""
    packages = (one.searched is None or comes_with_ros(one.name) for one in launch.packages)
    files = (one.exists or one.path.startswith(f"{UNKNOWN}/") for one in launch.files)
    return all(packages) and all(files)


def _without_joint_states(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    spawned = [(word, one) for one in started for word in controllers(one)]
    types = {name: one.type for name, one in defined_controllers(context).items() if one.ros == 2}
    known = [types.get((word.text or "").strip("/"), "") for word, _ in spawned]
    bridged = (topic for one in started for topic in bridged_topics(one, context.resolver))
    if (
        not all(known)
        or any(kind.endswith("JointStateBroadcaster") for kind in known)
        or any(one.package in _JOINT_STATES for one in started)
        or any(topic.ros_type.endswith("/JointState") for topic in bridged)
    ):
        return
    for word, one in spawned[:1]:
        yield Finding(
            Location(word.span, one.frame),
            "nothing publishes the joint states: no joint_state_broadcaster is started",
            "spawn joint_state_broadcaster, too, and define it in the YAML file of the controllers",
        )

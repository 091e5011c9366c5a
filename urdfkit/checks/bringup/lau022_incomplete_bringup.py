"""Controllers, or the node that publishes the robot, wait for what the launch file does not start.

- Controllers and robot_state_publisher are started, but no publisher of joint states: the links
  of moving joints have no transform, and RViz shows them at the origin. Spawn
  `joint_state_broadcaster`. A robot without moving joints, such as a sensor, needs none.
- `ros2_control_node` has no parameter file, so the types of the controllers are unknown.
- No robot_state_publisher publishes on the topic of `create -topic`: "Waiting messages on topic
  [robot_description]", for ever.
- `ros2_control_node` reads the robot from a topic that no robot_state_publisher publishes. Since
  Jazzy that is so even if it gets the robot as a parameter.
- A spawner looks for the controller manager in another namespace, or under another name: "Could not
  contact service /controller_manager/list_controllers". A relative name is in the namespace of the
  spawner; in ROS 1 the manager is in the `<robotNamespace>` of gazebo_ros_control.

A launch file is not checked if it includes unavailable files that are not part of ROS.

Sources:
    ros2_control, joint_state_broadcaster: https://control.ros.org/rolling/doc/ros2_controllers/joint_state_broadcaster/doc/userdoc.html
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    ros2_control, spawner.py: https://github.com/ros-controls/ros2_control/blob/master/controller_manager/controller_manager/spawner.py
"""

from urdfkit.checks.bringup.joint_states import missing_broadcaster, unpublished_joint_states
from urdfkit.checks.bringup.known_programs import are_topics_known, known_programs
from urdfkit.checks.bringup.mismatched_names import (
    manager_in_another_namespace,
    missing_description,
    unpublished_description,
    unread_description,
    untyped_controllers,
)
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

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


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    programs = known_programs(context)
    yield from missing_broadcaster(context, programs)
    yield from untyped_controllers(programs)
    if are_topics_known(context):
        yield from unpublished_description(context, programs)
        yield from unread_description(programs)
        yield from missing_description(context, programs)
        yield from unpublished_joint_states(context, programs)
        yield from manager_in_another_namespace(context, programs)

"""A topic is read that nothing publishes, or published that nothing reads.

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
- The collision monitor of Nav2 reads commands on another topic than that of the velocity smoother.

A launch file is not checked if it includes unavailable files that are not part of ROS.

Sources:
    turtlebot/turtlebot4#571: https://github.com/turtlebot/turtlebot4/issues/571
    robot_localization, ros_filter.cpp: https://github.com/cra-ros-pkg/robot_localization/blob/ros2/src/ros_filter.cpp
    twist_mux, twist_mux.cpp: https://github.com/ros-teleop/twist_mux/blob/rolling/src/twist_mux.cpp
"""

from urdfkit.checks.bringup.known_programs import are_topics_known
from urdfkit.checks.bringup.navigation_commands import mistyped_navigation, unpublished_commands
from urdfkit.checks.bringup.unpublished_odometry import unpublished_odometry
from urdfkit.checks.bringup.unpublished_topics import unpublished_inputs
from urdfkit.checks.bringup.unread_commands import mistyped_commands, unread_commands
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "launch/drive.launch.xml"
BAD = """\
<launch>
  <node pkg="teleop_twist_keyboard" exec="teleop_twist_keyboard"/>
  <node pkg="ros_gz_bridge" exec="parameter_bridge"
        args="/drive/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"/>
</launch>
"""
GOOD = BAD.replace("/drive/cmd_vel", "/cmd_vel")


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    if are_topics_known(context):
        yield from unpublished_inputs(context)
        yield from unread_commands(context)
        yield from unpublished_odometry(context)
        yield from mistyped_commands(context, context.launch.programs)
        yield from mistyped_navigation(context, context.launch.programs)
        yield from unpublished_commands(context)

"""A remapping has no effect, or makes a node read its own output.

- A spawner or robot_state_publisher remaps the topics of a controller, whose node is the controller
  manager. Pass `--controller-ros-args` to the spawner, or remap in ros2_control_node.
- A remapping is the wrong way round: from another name to that of the node.
- The node has no such topic: navsat_transform_node reads `imu`, not `imu/data` as in ROS 1.
- `cmd_vel_unstamped` of a drive is remapped, which it has only with `use_stamped_vel: false`.
- Gazebo's control plugin, or ros2_control_node, remaps a topic of a drive that is not there.
- `odometry/filtered` of robot_localization, or `cmd_vel_out` of twist_mux, is remapped to an input
  of its own.

Sources:
    ros2_controllers, topics of controllers: https://github.com/ros-controls/ros2_controllers/issues/262
    ros2_control_demos, remapping of a diff drive: https://github.com/ros-controls/ros2_control_demos/issues/185
"""

from urdfkit.checks.bringup.unread_remappings import (
    read_own_output,
    reversed_remappings,
    unknown_controllers,
    unknown_topics,
    unread_remappings,
    unstamped_commands,
)
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "launch/drive.launch.xml"
BAD = """\
<launch>
  <node pkg="controller_manager" exec="spawner" args="drive">
    <remap from="/drive/cmd_vel" to="/cmd_vel"/>
  </node>
</launch>
"""
GOOD = """\
<launch>
  <node pkg="controller_manager" exec="spawner"
        args="drive --controller-ros-args '-r /drive/cmd_vel:=/cmd_vel'"/>
</launch>
"""


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from unread_remappings(context)
    yield from reversed_remappings(context)
    yield from unknown_topics(context)
    yield from read_own_output(context)
    yield from unstamped_commands(context)
    yield from unknown_controllers(context)

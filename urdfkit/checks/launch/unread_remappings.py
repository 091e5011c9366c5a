"""Remappings of topics that a node does not have, because a controller has them.

A controller runs in the controller manager: in ros2_control_node, or in Gazebo.

Sources: ros-controls/ros2_controllers#262 and #1246, ros-controls/ros2_control_demos#185, and
``spawner.py`` of ros2_control (humble to rolling).
"""

from urdfkit.lint.rules import Context, Finding, Findings, Location, Severity
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import MANAGER, controllers

_HELP = (
    'pass --controller-ros-args "-r OLD:=NEW" to the spawner, or remap in ros2_control_node or in '
    "<ros> of Gazebo's plugin"
)


def unread_remappings(context: Context) -> Findings:
    """Remappings of controllers' topics in a spawner or in robot_state_publisher."""
    launch = context.launch
    spawned = {word.text for node in launch.programs for word in controllers(node)}
    for node in launch.started:
        for name in node.remappings or () if node.is_ros_2 else ():
            if _is_spawner(node):
                is_unread = MANAGER not in name
            else:
                owner = name.strip("/").partition("/")[0]
                is_unread = node.package == "robot_state_publisher" and owner in spawned
            if is_unread:
                yield Finding(
                    Location(node.span, node.frame),
                    f"remapping of '{name}' has no effect: controllers run in the controller "
                    f"manager, not in '{node.executable}'",
                    _HELP,
                    severity=Severity.WARNING,
                )


def _is_spawner(started: StartedProgram) -> bool:
    return any(True for _ in controllers(started))

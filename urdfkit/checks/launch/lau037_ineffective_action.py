"""An action of a launch file never starts, starts twice, or applies to no node.

- An action is created but not added to the launch description, so it is never started (info if a
  comment names it: it is left out on purpose; or if it is an event handler). Or an event handler
  waits for it.
- An action waits for the exit of a node that does not exit, such as robot_state_publisher, and
  never starts; or for its own exit; or for that of an included launch file, which is no process
  (error).
- An action is both in the launch description and in an event handler of it (error): launch starts
  it once and stops at the second start. Or an event handler without `target_action` starts a
  process at an event of each process.
- `SetParameter`, `push_ros_namespace` or a similar action stands behind the last node: it applies
  to the actions after it.

Sources:
    launch, event handlers: https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Event-Handlers.html
    launch, execute_local.py: https://github.com/ros2/launch/blob/rolling/launch/launch/actions/execute_local.py
"""

from urdfkit.checks.launch.launch_problems import launch_problems
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "robot.launch.py"
BAD = """\
from launch import LaunchDescription
from launch_ros.actions import Node, PushRosNamespace


def generate_launch_description():
    rviz = Node(package="rviz2", executable="rviz2")
    return LaunchDescription([rviz, PushRosNamespace("left")])
"""
GOOD = BAD.replace('rviz, PushRosNamespace("left")', 'PushRosNamespace("left"), rviz')


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    return launch_problems(context, "LAU037")

"""The command line of a program is not split into its words, or has an option that it rejects.

- The command line of `ExecuteProcess` is one string: launch looks for a program that is called
  `ros2 topic list`. Or a comma is missing between two words, which Python joins.
- The parts of a `Command` have no space between them. launch concatenates them:
  `["xacro", path]` runs a program called `xacro/home/...`; in `["xacro ", path, "sim:=true"]` the
  argument becomes part of the file name. Write `["xacro ", path, " sim:=true"]`. Or it has no
  program: `Command([path])` tries to run the description itself.
- ROS arguments are not as rcl reads them: `-p name=value`. ROS 2 ignores the parameters of ROS 1,
  `_name:=value` (warning).
- An option of the spawner, of static_transform_publisher or of the agent of micro-ROS, or a verb or
  state of `ros2 control`, does not exist, or no longer (info or warning). Or the spawner gets no
  name of a controller.
- Cartographer lacks one of its two options, or it is misspelt.
- static_transform_publisher has a wrong number of arguments: a period after the frames belongs to
  ROS 1. Or its angles are in degrees.
- A node that reads the keyboard, such as teleop_twist_keyboard, has no terminal in a launch file of
  ROS 2 (warning): "Inappropriate ioctl for device". Start it in one of its own, with
  `prefix="xterm -e"`.

Sources:
    cartographer_ros, node_main.cc: https://github.com/cartographer-project/cartographer_ros/blob/master/cartographer_ros/cartographer_ros/node_main.cc
    launch, execute_local.py: https://github.com/ros2/launch/blob/rolling/launch/launch/actions/execute_local.py
    launch, command.py: https://github.com/ros2/launch/blob/rolling/launch/launch/substitutions/command.py
    rcl, arguments.c: https://github.com/ros2/rcl/blob/rolling/rcl/src/rcl/arguments.c
    ros2_control, spawner: https://control.ros.org/rolling/doc/ros2_control/controller_manager/doc/userdoc.html
"""

from urdfkit.checks.launch.launch_problems import launch_problems
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.transforms import wrong_words

NAME = "robot.launch.py"
BAD = """\
from launch.actions import ExecuteProcess

actions = [ExecuteProcess(cmd=["ros2 topic list"])]
"""
GOOD = BAD.replace('"ros2 topic list"', '"ros2", "topic", "list"')


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from launch_problems(context, "LAU036")
    yield from _without_terminal(context)
    for program in context.launch.started:
        for word, message, help in wrong_words(program):
            yield Finding(Location(word.span, program.frame), message, help)


def _without_terminal(context: Context) -> Findings:
    """Nodes that read the keyboard, which launch of ROS 2 does not pass to them."""
    if b"prefix" in context.source.data:
        return
    interactive = data("launch")["interactive"]
    for node in context.launch.started:
        if node.key in interactive and node.is_ros_2:
            is_python = context.source.path.endswith(".py")
            yield Finding(
                Location(node.span, node.frame),
                f"'{node.executable}' reads the keyboard and stops: it has no terminal in a "
                "launch file",
                f'write {"prefix" if is_python else "launch-prefix"}="xterm -e", or start it with '
                "ros2 run",
                severity=Severity.WARNING,
            )

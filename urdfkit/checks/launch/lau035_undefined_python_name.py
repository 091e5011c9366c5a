"""A launch file in Python uses a name that it does not define or import.

`ros2 launch` stops: "name 'Node' is not defined"; under a condition, only where it holds (warning).
Or a name is imported from a module that does not have it: "cannot import name".

Sources:
    Python, NameError: https://docs.python.org/3/library/exceptions.html#NameError
    Python, ImportError: https://docs.python.org/3/library/exceptions.html#ImportError
"""

from urdfkit.checks.launch.launch_problems import launch_problems
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "robot.launch.py"
GOOD = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package="rviz2", executable="rviz2")])
"""
BAD = GOOD.replace("from launch_ros.actions import Node\n", "")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    return launch_problems(context, "LAU035")

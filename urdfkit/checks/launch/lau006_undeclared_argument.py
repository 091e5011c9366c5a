"""A launch file uses an argument that it does not declare.

`roslaunch` stops with "requires the 'x' arg to be set", `ros2 launch` with "launch configuration
'x' does not exist". The name is misspelt, or the declaration is missing or comes too late. A name
that does not resemble a declared one is a warning in ROS 2, where the file works if the caller sets
the argument, although `--show-args` does not list it, and an info in ROS 1, where `roslaunch`
reports missing arguments. Declare the argument, without a default if it must be set. A launch file
that other files include is not reported: they may set its arguments.

Sources:
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML/arg
    launch, launch_configuration.py: https://github.com/ros2/launch/blob/rolling/launch/launch/substitutions/launch_configuration.py
"""

from urdfkit.lint.rules import Context, Findings, Need, Severity, reported, rule

NAME = "robot.launch"
BAD = """\
<launch>
  <arg name="use_gui" default="true"/>
  <node name="rviz" pkg="rviz" type="rviz" if="$(arg use_giu)"/>
</launch>
"""
GOOD = BAD.replace("use_giu", "use_gui")


@rule(Severity.ERROR, needs=(Need.LAUNCH,), help="declare the argument, or fix its name")
def check(context: Context) -> Findings:
    yield from reported(context, "LAU006")

"""A launch file uses an argument that it does not declare.

`roslaunch` stops with "requires the 'x' arg to be set", `ros2 launch` with "launch configuration
'x' does not exist". The name is misspelt, or the declaration is missing or comes too late. A name
that is not like a declared one is a warning in ROS 2: the file works if the caller sets the
argument, although a list of the file's arguments does not show it. It is an info in ROS 1, where
`roslaunch` names what is not set. Declare it, without a default if it must be set. A file that
others include may get its arguments there, and is not reported.

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

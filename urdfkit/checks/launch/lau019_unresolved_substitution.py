"""A YAML file has a substitution that the launch file does not resolve.

The node gets `$(arg prefix)` or `$(find-pkg-share pkg)` literally. roslaunch resolves substitutions
with `subst_value="true"`, launch of ROS 2 with `allow_substs="true"`.

Sources:
    roslaunch, rosparam: https://wiki.ros.org/roslaunch/XML/rosparam
    launch_ros, ParameterFile: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/parameter_descriptions.py
"""

from urdfkit.lint.rules import Context, Findings, Need, Severity, reported, rule

NAME = "robot.launch"
BAD = '<launch><rosparam command="load" file="$(dirname)/control.yaml"/></launch>'
GOOD = BAD.replace('yaml"', 'yaml" subst_value="true"')
FILES = {"control.yaml": b"drive:\n  base_frame_id: $(arg prefix)base_link\n"}


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from reported(context, "LAU019")

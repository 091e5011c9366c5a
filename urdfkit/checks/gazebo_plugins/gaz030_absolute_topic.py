"""A plugin publishes or subscribes to a topic whose name begins with a slash.

Such a name is absolute: the namespace of the robot is not prepended, and two robots of the same
model share the topic, so that both execute the same command. Without the slash the name is
relative.

Sources:
    ROS 2, names: https://design.ros2.org/articles/topic_and_service_names.html
    ros-simulation/gazebo_ros_pkgs#920: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/920
"""

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, plugin_xml, solid_xml

_TAGS = "<commandTopic>/cmd_vel</commandTopic>", "<robotBaseFrame>base</robotBaseFrame>"
BAD = robot_xml(
    solid_xml("base"), gazebo_xml(plugin_xml("drive", "libgazebo_ros_planar_move.so", *_TAGS))
)
GOOD = BAD.replace("/cmd_vel<", "cmd_vel<")


@rule(Severity.INFO, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    for use in context.plugins:
        if use.plugin is None or use.plugin.generation not in ("classic-ros1", "classic-ros2"):
            continue  # in gz-sim a topic is absolute in any case
        for item in use.items:
            parameter = use.plugin.parameters.get(item.path)
            topic = item.text if parameter and parameter.type == "topic" else ""
            if item.path == "ros/remapping":
                topic = item.text.rpartition(":=")[2].strip()
            if topic.startswith("/") and len(topic) > 1:
                yield Finding(
                    item.at,
                    f"{use.title}: topic '{topic}' is absolute and ignores the robot namespace",
                    f"write '{topic.lstrip('/')}' if the robot may get a namespace",
                )

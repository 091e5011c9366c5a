"""A composable node cannot be loaded: its class or its container has another name.

- The class is written with a slash, or the package has another one: "Failed to find class with the
  requested plugin name".
- The container has another name with its namespace, so that the node waits for it.
- A `Node`, which is a program of its own, is in place of a `ComposableNode`.

Sources:
    ROS 2, composition: https://docs.ros.org/en/rolling/Concepts/Intermediate/About-Composition.html
    launch_ros, load_composable_nodes.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/actions/load_composable_nodes.py
"""

from urdfkit.checks.launch.launch_problems import launch_problems
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "robot.launch.xml"
BAD = """\
<launch>
  <node_container pkg="rclcpp_components" exec="component_container" name="camera" namespace="">
    <composable_node pkg="image_proc" plugin="image_proc/RectifyNode" name="rectify"/>
  </node_container>
</launch>
"""
GOOD = BAD.replace("image_proc/RectifyNode", "image_proc::RectifyNode")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    return launch_problems(context, "LAU038")

"""RViz shows nothing of what its configuration names.

- A display has a class that RViz 2 does not have, such as `rviz/LaserScan` of ROS 1.
- The robot's meshes have paths, such as `$(find PACKAGE)/mesh.stl`, or Gazebo's `model://`: "Could
  not load resource".
- A display requires reliable messages, which a node publishes as best effort.
- The display of the map is volatile, and misses what map_server published before.
- The tool for goals or for the initial pose has the topic of ROS 1 or a misspelt one, which Nav2
  does not read.
- The frames of the robot have a `frame_prefix` that RobotModel does not have as `TF Prefix`, or
  robot_state_publisher publishes them on `/robot1/tf`, while RViz reads `/tf`.

Sources:
    RViz 2, display types: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/plugins_description.xml
    resource_retriever: https://github.com/ros/resource_retriever/blob/rolling/resource_retriever/src/retriever.cpp
"""

from urdfkit.checks.bringup.rviz_displays import (
    incompatible_reliability,
    meshes_without_uri,
    unknown_classes,
    unread_goals,
    volatile_maps,
)
from urdfkit.checks.bringup.rviz_frames import unprefixed_models, unread_transforms
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "launch/view.launch.xml"
BAD = """\
<launch>
  <node pkg="rviz2" exec="rviz2" args="-d $(dirname)/../view.rviz"/>
</launch>
"""
GOOD = BAD.replace("view.rviz", "sound.rviz")
_DISPLAYS = b"Visualization Manager:\n  Displays:\n    - Class: %s/LaserScan\n"
FILES = {
    "view.rviz": _DISPLAYS % b"rviz",
    "sound.rviz": _DISPLAYS % b"rviz_default_plugins",
    "package.xml": b"<package><name>arm</name></package>",
}


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from unknown_classes(context)
    yield from meshes_without_uri(context)
    yield from volatile_maps(context)
    yield from incompatible_reliability(context)
    yield from unread_goals(context)
    yield from unprefixed_models(context)
    yield from unread_transforms(context)

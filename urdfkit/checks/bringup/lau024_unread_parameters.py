"""No node reads parameters that a launch file loads.

- The node of a parameter file has another name or namespace than the node in the launch file. ROS 2
  reads only the parameters below the name of the node or below `/**`, silently ignores all others,
  and uses the node's defaults.
- The parameters of a costmap are not below its name twice: `local_costmap: local_costmap:` (error).
  Or the parameters of a plugin are below another name than the list of plugins has.
- A parameter file is a list, such as the topics of ros_gz_bridge, which belong into `config_file`
  (error).
- A parameter of a node or plugin of Nav2, of slam_toolbox or of a driver is misspelt, or has the
  name of an earlier release: `dev` of joy_node, `enable_pointcloud` of realsense2_camera.
- A name is that of an earlier release, while other files are for Jazzy: `recoveries_server`,
  `progress_checker_plugin`, Nav2's own libraries in `plugin_lib_names`, a twist_mux without
  `use_stamped`.
- Nothing of an input of robot_localization is read, as `odom0_config` or the like is missing. A
  filter of a costmap is not in `filters` (info).

Sources:
    ROS 2, parameter files: https://docs.ros.org/en/rolling/How-To-Guides/Node-arguments.html
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    Nav2, migration guides: https://docs.nav2.org/migration
    twist_mux, use_stamped: https://github.com/ros-teleop/twist_mux/issues/53
"""

import os

from urdfkit.checks.bringup import costmap_parameters, parameter_names, parameter_sections
from urdfkit.checks.bringup.read_parameters import (
    parameter_files,
    parameters_of_started,
    whole_sections,
)
from urdfkit.checks.bringup.renamed_parameters import outdated
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.text.located_yaml import load

NAME = "launch/filter.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [
    Node(
        package="robot_localization",
        executable="ekf_node",
        name="ekf_node",
        parameters=["../ekf.yaml"],
    ),
]
"""
GOOD = BAD.replace('name="ekf_node"', 'name="ekf_filter_node"')
FILES = {
    "ekf.yaml": b"ekf_filter_node:\n  ros__parameters:\n    frequency: 30.0\n",
    "package.xml": b"<package><name>arm</name></package>",
}

_CONFIG_FILE = 'write {"config_file": PATH} in its parameters'
_BELOW_NODE = "write the parameters below the name of the node and ros__parameters"


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    files = parameter_files(context)
    sections = [section for own in files.values() for section in own]
    started = parameters_of_started(context, files)
    for section in (*sections, *started):
        yield from parameter_names.misspelt(section)
        yield from parameter_names.with_commas(section)
    for section in whole_sections(sections):
        yield from parameter_sections.unread_plugins(section)
        yield from parameter_sections.misplaced(section)
        yield from parameter_sections.unlisted_filters(section)
        yield from costmap_parameters.of_sources(section)
        yield from parameter_sections.unnumbered_filters(section)
        yield from parameter_names.unread_inputs(section)
    yield from outdated(context, [*sections, *started])
    yield from parameter_names.without_inputs(context)
    yield from _lists(context)
    yield from parameter_sections.misnamed_sections(context, files)


def _lists(context: Context) -> Findings:
    """Files that are a list, such as the topics of a bridge, which ROS 2 does not read."""
    of_ros2 = {
        path for node in context.launch.started for path in node.parameters.files if node.is_ros_2
    }
    for file in context.launch.parameters:
        source = context.resolver.readable(file.path) if file.path in of_ros2 else None
        if source and file.span.source is context.source and isinstance(load(source), list):
            is_bridge = b"ros_topic_name" in source.data
            yield Finding(
                file.span,
                f"'{os.path.basename(file.path)}' is a list, not the parameters of a node, which "
                "stops at it",
                _CONFIG_FILE if is_bridge else _BELOW_NODE,
                severity=Severity.ERROR,
            )

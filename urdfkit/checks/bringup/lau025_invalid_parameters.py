"""A node stops at its parameters: a value or a type is invalid, or a parameter is missing.

- ROS 2 rejects the file: a value is not below `ros__parameters`, or is missing, or a list has
  values of several types, such as `[1, 0.5]`, or mappings.
- A value has another type than the declared one, such as an integer for a double: "expected
  [double] got [integer]". A list contains lists.
- `odom0_config` or a similar parameter does not have 15 values, five rows of three, as
  robot_localization requires.
- A mode or a footprint is invalid, a list has the wrong length, or a limit the wrong sign. A
  required parameter is missing (warning): "parameter 'polygons' is not initialized".
- A plugin in `plugins` or `filters` of a costmap has no parameters: "Can not get 'plugin' param
  value for voxel_layer". The same holds for `controller_plugins` and the other lists of Nav2, and
  for polygons, sources and docks. A source in `observation_sources` has no parameters (warning):
  the layer subscribes to a topic of that name.
- A planner or controller of Nav2 is misspelt (warning), lacks its critics or its primary
  controller, or has an unknown critic. The classes of plugins have names of different versions of
  Nav2 (warning).
- A costmap layer has an unknown class or an unsupported `data_type`.
- A behaviour tree has no full path, or the default one calls a behaviour that is not in
  `behavior_plugins` (warnings). A behaviour tree has a node or a port that Nav2 does not have
  (warnings), a decorator without exactly one child, or the name of a tree that is not there.
- The frames of the map and of odometry are swapped (warning).
- The `frame_prefix` of robot_state_publisher begins with a slash, or is the namespace without one
  behind it (warnings).
- `robot_model_type` of AMCL is a name of ROS 1 (warning): Humble and later load a class.
- The Lua file of Cartographer does not exist, lacks an option, has an unknown one, or no input.
- A filter of laser_filters is misspelt. A dock has a type that is not in `dock_plugins` (warning).
- A map lacks a value or has an invalid one, at which map_server stops. Or it gets no map (warning).
  For `localization` slam_toolbox needs a `map_file_name` (info).

Sources:
    ROS 2, parser of parameter files: https://github.com/ros2/rcl/blob/rolling/rcl_yaml_param_parser/src/parse.c
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    Nav2, map server: https://docs.nav2.org/configuration/packages/configuring-map-server.html
    rst-tu-dortmund/teb_local_planner#202: https://github.com/rst-tu-dortmund/teb_local_planner/issues/202
"""

from urdfkit.checks.bringup import costmap_parameters, parameter_types, parameter_values
from urdfkit.checks.bringup.behavior_trees import invalid_trees
from urdfkit.checks.bringup.cartographer import invalid_configurations
from urdfkit.checks.bringup.invalid_maps import invalid_maps, missing_graphs, missing_maps
from urdfkit.checks.bringup.plugin_parameters import missing_in_default_trees, unloadable_plugins
from urdfkit.checks.bringup.read_parameters import (
    parameter_files,
    parameters_of_started,
    whole_sections,
)
from urdfkit.checks.bringup.rejected_files import rejected_files
from urdfkit.lint.rules import Context, Findings, Need, Severity, rule

NAME = "launch/filter.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [
    Node(
        package="robot_localization",
        executable="ekf_node",
        name="ekf_filter_node",
        parameters=["../ekf.yaml"],
    ),
]
"""
GOOD = BAD.replace("ekf.yaml", "sound.yaml")
_EKF = b"ekf_filter_node:\n  ros__parameters:\n    odom0: odom\n    odom0_config: [%s]\n"
_XY_AND_YAW = (b"true, true, false", b"false, false, true")
_REST = b"false, false, false"
FILES = {
    "ekf.yaml": _EKF % b", ".join((*_XY_AND_YAW, _REST)),
    "sound.yaml": _EKF % b", ".join((*_XY_AND_YAW, _REST, _REST, _REST)),
    "package.xml": b"<package><name>arm</name></package>",
}


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    files = parameter_files(context)
    sections = [section for own in files.values() for section in own]
    for section in (*sections, *parameters_of_started(context, files)):
        yield from parameter_types.wrong_types(section)
        yield from parameter_values.invalid_values(section)
        yield from parameter_values.wrong_signs(section)
    for section in sections:
        yield from parameter_types.wrong_configurations(section)
        yield from parameter_types.inputs_of_twist_mux(section)
        yield from parameter_types.outdated_motion_model(section)
        yield from parameter_types.wrong_sizes(section)
        yield from costmap_parameters.unknown_classes(section)
        yield from costmap_parameters.of_laser_filters(section)
        yield from costmap_parameters.types_of_docks(section)
    for section in whole_sections(sections):
        yield from costmap_parameters.plugins(section)
        yield from unloadable_plugins(section)
        yield from parameter_values.missing(section)
    for own in files.values():
        yield from costmap_parameters.mixed_names(own)
    yield from parameter_values.invalid_prefixes(context.launch.programs)
    yield from missing_in_default_trees(context, sections)
    yield from invalid_trees(context, sections)
    yield from parameter_values.missing_of_programs(context)
    yield from rejected_files(context)
    yield from invalid_configurations(context)
    yield from invalid_maps(context)
    yield from missing_maps(context)
    yield from missing_graphs(context, sections)

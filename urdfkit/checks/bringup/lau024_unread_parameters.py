"""Parameters of a node are not read, or stop it.

- The node of a parameter file has another name or namespace than the node in the launch file
  (warning). ROS 2 reads only the parameters below the name of the node or below `/**`, silently
  ignores all others, and uses the node's defaults.
- A parameter file is a list, such as the topics of ros_gz_bridge, which belong into `config_file`.
- `odom0_config` or a similar parameter does not have 15 values, five rows of three, as
  robot_localization requires.
- A plugin in `plugins` or `filters` of a costmap has no parameters: "Can not get 'plugin' param
  value for voxel_layer". The same holds for `controller_plugins` and the other lists of Nav2. Or
  the parameters of a plugin are below another name than the list has (warning).
- A parameter of a node or plugin of Nav2, or of slam_toolbox, is misspelt (warning), or a
  required one is missing (warning): "parameter 'polygons' is not initialized". A mode or a
  footprint is invalid, a list has the wrong length, or a limit the wrong sign. The classes of
  plugins have names of different versions of Nav2 (warning), or nothing of an input of
  robot_localization is read (warning).
- Values contradict one another: the step of MPPI is below the period of the controller, which stops
  it; an inflation radius is within the robot, rays that clear obstacles are shorter than the range
  of obstacles, or no source clears them; a minimum is above its maximum; an initial pose is given
  without `set_initial_pose`; the heights of obstacles exclude all lidars of the robot; a row of
  `imu0_config` is of values that an IMU does not have (all warnings but the first). With a
  `transform_publish_period` of 0 slam_toolbox publishes no transform, and for `localization` it
  needs a `map_file_name` (infos). A filter reads the
  acceleration of an IMU with that of gravity (info). A critic of MPPI considers the footprint of a
  robot that has only a radius.
- A name is that of an earlier release, while other files are for Jazzy: `recoveries_server`,
  `progress_checker_plugin`, Nav2's own libraries in `plugin_lib_names`, a twist_mux without
  `use_stamped` (warnings). Nodes of Nav2 differ in `enable_stamped_cmd_vel` (warning).
- A map lacks a value or has an invalid one, at which map_server stops. Or it gets no map (warning).
- A controller lacks its critics or its primary controller, or has an unknown critic. A polygon, a
  source or a dock has no parameters. A behaviour tree has no full path, or the frames of the map
  and of odometry are swapped (warnings).
- A costmap layer has an unknown class or an unsupported `data_type`. Or an obstacle layer stands
  behind the last inflation layer, which does not inflate its obstacles (warning).
- A costmap without a map does not move with the robot (`rolling_window`), is smaller than its
  footprint, or has the map in the frame of odometry. A server of Nav2 reads the footprint or the
  costs from a topic that a costmap does not publish, or `allow_reversing` of the regulated pure
  pursuit is given with `use_rotate_to_heading` (warnings). A layer reads a relative topic, which up
  to Jazzy is in the namespace of the costmap (warning; an info for Jazzy). A filter is not in
  `filters` (info).
- The parameters of a costmap are not below its name twice: `local_costmap: local_costmap:`.
- A value has another type than the declared one, such as an integer for a double: "expected
  [double] got [integer]". A list contains lists. A planner or controller of Nav2 is misspelt
  (warning).
- A source in `observation_sources` has no parameters (warning): the layer subscribes to a topic of
  that name.
- A lifecycle manager waits for a node that nothing starts, or no lifecycle manager activates a node
  of Nav2, or of slam_toolbox since Jazzy, which stays unconfigured (warning). Or `autostart` of the
  manager is false, as it is by default (warning).
- An RViz configuration has a display of a class that RViz 2 does not have, such as `rviz/LaserScan`
  of ROS 1 (warning): the display stays empty. Or it shows a robot whose meshes have paths, such as
  `$(find PACKAGE)/mesh.stl`, or Gazebo's `model://`: "Could not load resource" (warning). Or its
  display of the map is volatile, and misses what map_server published before (warning). Or its tool
  for goals or for the initial pose has the topic of ROS 1 or a misspelt one (warning).
- A planning pipeline of MoveIt has no plugin (warning), neither in the file of MoveItConfigsBuilder
  nor in the dictionaries that the launch file passes to move_group ("Planning plugin name is empty
  or not defined in namespace 'ompl'"). Or `default_planning_pipeline` is not in
  `planning_pipelines` (warning; the builder stops). Or the solvers are not below
  `robot_description_kinematics` (info: in Humble they may also be at the top level). RViz does not
  get them (warning): "No active joints or end effectors found", and no interactive markers.
- A file of MoveItConfigsBuilder has `ros__parameters`, or the name that the builder puts around it
  (warning). Or move_group gets no SRDF (warning).
- `robot_model_type` of AMCL is a name of ROS 1 (warning): Humble and later load a class.
- A spawner or robot_state_publisher remaps the topics of a controller (warning), whose node is the
  controller manager. Or a remapping is the wrong way round: from another name to that of the node.
  Or `odometry/filtered` of robot_localization is remapped to its own input (warning).
- static_transform_publisher has an unknown option or a wrong number of arguments: a period after
  the frames belongs to ROS 1.

Sources:
    ROS 2, parameter files: https://docs.ros.org/en/rolling/How-To-Guides/Node-arguments.html
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    MoveIt, since Iron: https://github.com/Interbotix/interbotix_ros_manipulators/issues/133
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    ros2_controllers, topics of controllers: https://github.com/ros-controls/ros2_controllers/issues/262
    Nav2, lifecycle manager: https://docs.nav2.org/configuration/packages/configuring-lifecycle.html
    Nav2, migration guides: https://docs.nav2.org/migration
    twist_mux, use_stamped: https://github.com/ros-teleop/twist_mux/issues/53
"""

import os
from itertools import chain

from urdfkit.checks.bringup import (
    costmap_geometry,
    costmap_parameters,
    parameter_names,
    parameter_types,
)
from urdfkit.checks.bringup.invalid_maps import invalid_maps, missing_graphs, missing_maps
from urdfkit.checks.bringup.lifecycle import inactive_mapping, not_activated, not_started
from urdfkit.checks.bringup.navigation_commands import mixed_stamps
from urdfkit.checks.bringup.obstacle_heights import discarded_scans
from urdfkit.checks.bringup.parameter_relations import contradictions, without_footprint
from urdfkit.checks.bringup.parameter_sections import misnamed_sections
from urdfkit.checks.bringup.plugin_parameters import unloadable_plugins
from urdfkit.checks.bringup.renamed_parameters import outdated
from urdfkit.checks.bringup.rviz_displays import (
    meshes_without_uri,
    unknown_classes,
    unread_goals,
    volatile_maps,
)
from urdfkit.checks.bringup.unread_remappings import (
    read_own_output,
    reversed_remappings,
    unread_remappings,
    unstamped_commands,
)
from urdfkit.core.words import few
from urdfkit.lint.rules import (
    Context,
    Finding,
    Findings,
    Location,
    Need,
    Severity,
    reported,
    rule,
)
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.transforms import mistakes
from urdfkit.ros.node_parameters import node_parameters
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


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    read = (file for file in context.launch.parameters if file.exists and not file.is_of_ros1)
    paths = dict.fromkeys(file.path for file in read)
    sources = filter(None, map(context.resolver.readable, paths))
    files = {source.path: list(node_parameters(source)) for source in sources}
    sections = list(chain.from_iterable(files.values()))
    names = [section.name for section in sections]
    for section in sections:
        yield from parameter_types.wrong_configurations(section)
        yield from parameter_types.wrong_types(section)
        yield from parameter_types.outdated_motion_model(section)
        yield from parameter_types.wrong_sizes(section)
        yield from parameter_names.misspelt(section)
        yield from parameter_names.invalid_values(section)
        yield from parameter_names.wrong_signs(section)
        yield from costmap_parameters.misspelt_servers(section)
        yield from contradictions(section)
        if names.count(section.name) == 1:  # otherwise another section may complete it
            yield from costmap_parameters.plugins(section)
            yield from unloadable_plugins(section)
            yield from parameter_names.missing(section)
            yield from parameter_names.unread_inputs(section)
            yield from costmap_parameters.misplaced(section)
            yield from costmap_parameters.not_inflated(section)
            yield from costmap_parameters.unlisted_filters(section)
            yield from costmap_geometry.unmoved(section)
        yield from costmap_geometry.misread_costmaps(section)
    for own in files.values():
        yield from costmap_parameters.mixed_names(own)
    yield from outdated(context, sections)
    yield from costmap_geometry.untransformed_map(sections)
    yield from costmap_geometry.relative_topics(context, sections)
    yield from without_footprint(sections)
    yield from mixed_stamps(sections)
    yield from discarded_scans(context, sections)
    yield from _lists(context)
    yield from misnamed_sections(context, files)
    yield from invalid_maps(context)
    yield from missing_maps(context)
    yield from missing_graphs(context, sections)
    yield from not_activated(context)
    yield from not_started(context)
    yield from inactive_mapping(context)
    yield from _of_programs(context)


def _of_programs(context: Context) -> Findings:
    """What RViz shows, remappings and arguments."""
    yield from unknown_classes(context)
    yield from meshes_without_uri(context)
    yield from volatile_maps(context)
    yield from unread_goals(context)
    yield from unread_remappings(context)
    yield from reversed_remappings(context)
    yield from read_own_output(context)
    yield from unstamped_commands(context)
    yield from reported(context, "LAU024")
    for program in context.launch.started:
        yield from _unknown_pipeline(program)
        yield from parameter_types.integer_frequency(program)
        for word, message, help in mistakes(program):
            yield Finding(Location(word.span, program.frame), message, help)


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
            )


def _unknown_pipeline(program: StartedProgram) -> Findings:
    """A default planning pipeline of MoveIt that is not loaded."""
    name = program.parameters.values.get("default_planning_pipeline")
    loaded = program.parameters.lists.get("planning_pipelines", ())
    names = [pipeline for pipeline in loaded if pipeline]
    if name and names and len(names) == len(loaded) and name not in names:
        yield Finding(
            program.at,
            f"default_planning_pipeline '{name}' is not in planning_pipelines: {few(names, 4)}",
            f"add '{name}' to planning_pipelines, with its settings",
            severity=Severity.WARNING,
        )

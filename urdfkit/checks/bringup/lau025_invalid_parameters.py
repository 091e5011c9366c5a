"""A node stops at its parameters: a value or a type is invalid, or a parameter is missing.

- ROS 2 rejects the file: a value is not below `ros__parameters`, or is missing, or a list has
  values of several types, such as `[1, 0.5]`, or mappings.
- A value has another type than the declared one, such as an integer for a double: "expected
  [double] got [integer]". A list contains lists.
- `odom0_config` or a similar parameter does not have 15 values, five rows of three, as
  robot_localization requires.
- A mode or a footprint is invalid, a list has the wrong length, or a limit the wrong sign. A
  required parameter is missing (warning): "parameter 'polygons' is not initialized". A polygon of
  the collision monitor has no shape, or fewer points than Jazzy requires (warning).
- The frames of the map and of odometry are swapped (warning).
- The `frame_prefix` of robot_state_publisher begins with a slash, or is the namespace without one
  behind it (warnings).
- `robot_model_type` of AMCL is a name of ROS 1 (warning): Humble and later load a class. The map
  saver has a `save_map_timeout` in ms (warning): since Galactic it is a double in s.

Sources:
    ROS 2, parser of parameter files: https://github.com/ros2/rcl/blob/rolling/rcl_yaml_param_parser/src/parse.c
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    rst-tu-dortmund/teb_local_planner#202: https://github.com/rst-tu-dortmund/teb_local_planner/issues/202
"""

from urdfkit.checks.bringup import parameter_types, parameter_values
from urdfkit.checks.bringup.polygons import incomplete_polygons
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
        yield from parameter_types.timeout_in_ms(section)
        yield from parameter_values.invalid_values(section)
        yield from parameter_values.wrong_signs(section)
    for section in sections:
        yield from parameter_types.wrong_configurations(section)
        yield from parameter_types.inputs_of_twist_mux(section)
        yield from parameter_types.outdated_motion_model(section)
        yield from parameter_types.wrong_sizes(section)
    for section in whole_sections(sections):
        yield from parameter_values.swapped_frames(section)
        yield from parameter_values.missing(section)
        yield from incomplete_polygons(section)
    yield from parameter_values.invalid_prefixes(context.launch.programs)
    yield from parameter_values.missing_of_programs(context)
    yield from rejected_files(context)

"""The file of Cartographer does not exist, lacks an option, has an unknown one, or no input.

The node stops. Each option must be there, and there must be no other: "Key 'x' not in dictionary",
"Key 'x' was used the wrong number of times".

Sources:
    cartographer_ros, Lua configuration: https://google-cartographer-ros.readthedocs.io/en/latest/configuration.html
    cartographer, lua_parameter_dictionary.cc: https://github.com/cartographer-project/cartographer/blob/master/cartographer/common/lua_parameter_dictionary.cc
"""

from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean, hint_for, nearest, nearest_file_name
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.launch.cartographer import CartographerConfiguration, configurations

NAME = "launch/slam.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [
    Node(
        package="cartographer_ros",
        executable="cartographer_node",
        arguments=[
            "-configuration_directory",
            "/home/student/arm_description",
            "-configuration_basename",
            "hal.lua",
        ],
    ),
]
"""
GOOD = BAD.replace("hal.lua", "hall.lua")
FILES = {
    "hall.lua": b'include "map_builder.lua"\nreturn options\n',
    "package.xml": b"<package><name>arm</name><depend>cartographer_ros</depend></package>",
}

_REQUIRED = (
    "map_builder", "trajectory_builder", "map_frame", "tracking_frame", "published_frame",
    "odom_frame", "provide_odom_frame", "publish_frame_projected_to_2d", "use_odometry",
    "use_nav_sat", "use_landmarks", "num_laser_scans", "num_multi_echo_laser_scans",
    "num_subdivisions_per_laser_scan", "num_point_clouds", "lookup_transform_timeout_sec",
    "submap_publish_period_sec", "pose_publish_period_sec", "trajectory_publish_period_sec",
    "rangefinder_sampling_ratio", "odometry_sampling_ratio", "fixed_frame_pose_sampling_ratio",
    "imu_sampling_ratio", "landmarks_sampling_ratio",
)  # fmt: skip
_OPTIONAL = ("use_pose_extrapolator", "publish_to_tf", "publish_tracked_pose", "imu_correction")
_INPUTS = ("num_laser_scans", "num_multi_echo_laser_scans", "num_point_clouds")
_MAX_NAMED = 4


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for configuration in configurations(context.launch.started, context.resolver):
        name, program = configuration.name, configuration.program
        if configuration.source is None:
            names = disk.names_or_empty(configuration.directory)
            files = [file for file in names if file.endswith(".lua")]
            message = f"'{program.title}' stops: '{name.text}' does not exist in its directory"
            message += hint_for(nearest_file_name(name.text or "", files))
            help = f"create it, or name {few(sorted(files), _MAX_NAMED)}" if files else "create it"
            yield Finding(Location(name.span, program.frame), message, help)
        elif program.is_ros_2 and configuration.is_whole and configuration.table:
            yield from _of_options(configuration)


def _of_options(configuration: CartographerConfiguration) -> Findings:
    options, who = configuration.options, f"'{configuration.program.title}' stops"
    lacking = [name for name in _REQUIRED if name not in options]
    for name, option in options.items():
        if name not in (*_REQUIRED, *_OPTIONAL):
            meant = nearest(name, lacking)
            lacking = [other for other in lacking if other != meant]
            message = f"{who}: it has no option '{name}'{did_you_mean(name, [meant or ''])}"
            yield Finding(option.name_span, message, f"write {meant}" if meant else "remove it")
    if lacking and configuration.table:
        message = f"{who}: the options lack {few(lacking, _MAX_NAMED)}"
        help = "add them, as in the files of cartographer_ros"
        yield Finding(configuration.table, message, help)
    counts = [options[name] for name in _INPUTS if name in options]
    if len(counts) == len(_INPUTS) and all(count.text == "0" for count in counts):
        message = f"{who}: it has no input, as {', '.join(_INPUTS)} are 0"
        yield Finding(counts[0].span, message, "write num_laser_scans = 1")

"""A node rejects the value of a parameter, or a parameter names the wrong frame.

- `odom0_config` or a similar parameter does not have 15 values, five rows of three, as
  robot_localization requires.
- A mode or a footprint is invalid, a list has the wrong length, or a limit the wrong sign.
- The frames of the map and of odometry are swapped (warning).
- The `frame_prefix` of robot_state_publisher begins with a slash, or is the namespace without one
  behind it (warnings).
- `robot_model_type` of AMCL is a name of ROS 1 (warning): Humble and later load a class.

Sources:
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    navigation2, velocity_smoother.cpp: https://github.com/ros-navigation/navigation2/blob/main/nav2_velocity_smoother/src/velocity_smoother.cpp
"""

from collections.abc import Iterable

from urdfkit.checks.bringup.parameter_values import invalid_values, wrong_signs
from urdfkit.checks.bringup.read_parameters import (
    parameters_of_nodes,
    read_sections,
    whole_sections,
)
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.known_parameters import CONFIGURATION
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import items, scalar

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

#: Values of a configuration of robot_localization: position, angles, velocities, rates,
#: accelerations.
_STATES = 15
_PREFIX = "frame_prefix"
#: Frames of localization that have the name of the other one.
_SWAPPED = {
    "odom_frame_id": "map",
    "odom_frame": "map",
    "global_frame_id": "odom",
    "map_frame": "odom",
}
_LOCALIZING = ("amcl", "slam_toolbox")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for section in parameters_of_nodes(context):
        yield from invalid_values(section)
        yield from wrong_signs(section)
    sections = read_sections(context)
    for section in sections:
        yield from _wrong_configurations(section)
        yield from _outdated_motion_model(section)
    for section in whole_sections(sections):
        yield from _swapped_frames(section)
    yield from _invalid_prefixes(context.launch.programs)


def _wrong_configurations(node: NodeParameters) -> Findings:
    """Configurations of robot_localization of another length than the filter reads."""
    for key, value in items(node.values):
        is_configuration = CONFIGURATION.fullmatch(key) is not None
        if is_configuration and isinstance(value, list) and len(value) != _STATES:
            yield Finding(
                key.span,
                f"'{node.name}': {key} has {len(value)} values, not {_STATES}",
                "write five rows: x y z, roll pitch yaw, their velocities, accelerations of x y z",
            )


def _outdated_motion_model(node: NodeParameters) -> Findings:
    """A motion model of AMCL with its name in ROS 1 and Foxy."""
    model = scalar(node.values, "robot_model_type")
    if model is None or node.name != "amcl":
        return
    if name := data("nodes")["motion_models"].get(model.text):
        yield Finding(
            model.span,
            f"'amcl' of Humble and later stops: robot_model_type is a class, not '{model.text}'",
            f"write {name}",
            severity=Severity.WARNING,
        )


def _swapped_frames(node: NodeParameters) -> Findings:
    """The frame of the map in place of that of odometry, or the reverse."""
    for key, wrong in _SWAPPED.items() if node.name in _LOCALIZING else ():
        value = scalar(node.values, key)
        if value and value.text.strip("/") == wrong:
            right = "odom" if wrong == "map" else "map"
            yield Finding(
                value.span,
                f"'{node.name}': {key} is '{wrong}', the frame of "
                f"{'the map' if wrong == 'map' else 'odometry'}",
                f"write {right}",
                severity=Severity.WARNING,
            )


def _invalid_prefixes(programs: Iterable[StartedProgram]) -> Findings:
    """Prefixes that make names of frames which tf2 or the reader does not know."""
    for node in programs:
        prefix = node.parameters.values.get(_PREFIX) or ""
        if node.package != "robot_state_publisher" or "$" in prefix:
            continue
        if prefix == "/":
            continue  # tf2 strips it
        if prefix.startswith("/"):
            message = f"{_PREFIX} '{prefix}' begins with a slash, as no name of tf2 does"
            yield Finding(
                node.at, message, f"write {prefix.strip('/')}/", severity=Severity.WARNING
            )
        elif prefix and prefix == (node.namespace or "").strip("/"):
            message = f"{_PREFIX} '{prefix}' has no slash: the frames are called {prefix}base_link"
            yield Finding(node.at, message, f"write {prefix}/", severity=Severity.WARNING)

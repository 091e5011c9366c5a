"""No node reads parameters that a launch file loads.

- The node of a parameter file has another name or namespace than the node in the launch file. ROS 2
  reads only the parameters below the name of the node or below `/**`, silently ignores all others,
  and uses the node's defaults.
- The parameters of a costmap are not below its name twice: `local_costmap: local_costmap:` (error).
  Or the parameters of a plugin are below another name than the list of plugins has.
- A parameter file is a list, such as the topics of ros_gz_bridge, which belong into `config_file`
  (error).
- A parameter of a node of Nav2 is in the section of its plugin, or that of a plugin is not in it.
- A parameter of a node or plugin of Nav2, of slam_toolbox or of a driver is misspelt, or has the
  name of an earlier release: `dev` of joy_node, `enable_pointcloud` of realsense2_camera. Or
  `use_sim_time` of any node is misspelt.
- A name is that of an earlier release, while other files are for Jazzy: `recoveries_server`,
  `progress_checker_plugin`, Nav2's own libraries in `plugin_lib_names`, a twist_mux without
  `use_stamped`.
- Nothing of an input of robot_localization is read, as `odom0_config` or `odom0` is missing, or of
  the sources of a costmap's layer without `observation_sources`. A filter of a costmap is not in
  `filters` (info).

Sources:
    ROS 2, parameter files: https://docs.ros.org/en/rolling/How-To-Guides/Node-arguments.html
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    Nav2, migration guides: https://docs.nav2.org/migration
    twist_mux, use_stamped: https://github.com/ros-teleop/twist_mux/issues/53
"""

import os
import re

from urdfkit.checks.bringup import costmap_layers, parameter_sections
from urdfkit.checks.bringup.read_parameters import (
    parameter_files,
    parameters_of_started,
    whole_sections,
)
from urdfkit.checks.bringup.renamed_parameters import outdated
from urdfkit.core.suggest import CLOSE_TYPO, did_you_mean, is_typo, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.launch.known_parameters import (
    CONFIGURATION,
    GivenValue,
    given_values,
    parameters_of_node,
    parameters_of_plugin,
    plugin_class,
)
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Value, entries, items, load, mapping
from urdfkit.text.source import Span

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
_INPUT = re.compile(r"(odom|imu|pose|twist)\d+")
_FILTERS = ("ekf_node", "ukf_node")
#: Parameters that all nodes have, and many plugins.
_SIM_TIME = "use_sim_time"
_OF_ALL = (_SIM_TIME, "plugin", "enabled")
#: Letters of words that are not typos of each other.
_SHORT = 3


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    files = parameter_files(context)
    sections = [section for own in files.values() for section in own]
    started = parameters_of_started(context, files)
    for section in (*sections, *started):
        yield from _misspelt(section)
        yield from _with_commas(section)
    yield from _misspelt_clock(context, sections)
    for section in whole_sections(sections):
        yield from parameter_sections.unread_plugins(section)
        yield from parameter_sections.misplaced(section)
        yield from parameter_sections.unlisted_filters(section)
        yield from costmap_layers.misplaced_source_parameters(section)
        yield from costmap_layers.unlisted_sources(section)
        yield from parameter_sections.unnumbered_filters(section)
        yield from _unread_inputs(section)
        yield from _of_other_level(section)
    yield from outdated(context, [*sections, *started])
    yield from _without_inputs(context)
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


def _misspelt(node: NodeParameters) -> Findings:
    """Parameters that the node ignores, and that are one letter away from one that it reads."""
    for given in given_values(node):
        suggested = _meant(given)
        if suggested and suggested != _SIM_TIME:
            yield _unknown(node.name, given.at, suggested, given.at.span)


def _unknown(node: str, name: str, suggested: str, at: Span) -> Finding:
    message = f"'{node}': unknown parameter '{name}'; did you mean '{suggested}'?"
    return Finding(at, message, f"write {suggested}")


def _is_clock(name: str) -> bool:
    """True for a typo of use_sim_time."""
    return name != _SIM_TIME and is_typo(name, _SIM_TIME)


def _misspelt_clock(context: Context, sections: list[NodeParameters]) -> Findings:
    """A misspelt use_sim_time, which every node reads."""
    for section in sections:
        for key, _ in items(section.values):
            if _is_clock(key) and _SIM_TIME not in section.values:
                yield _unknown(section.name, key, _SIM_TIME, key.span)
    for program in context.launch.started:
        for name, at in program.parameters.at.items() if program.is_ros_2 else ():
            if _is_clock(name):
                yield _unknown(program.title, name, _SIM_TIME, at)


def _of_other_level(node: NodeParameters) -> Findings:
    """Parameters of a node in the section of its plugin, or the other way round."""
    sections = {str(name): mapping(section) for name, section in node.values.items()}
    known = {
        name: parameters_of_plugin(plugin_class(section)) for name, section in sections.items()
    }
    own = parameters_of_node(node)
    for name, section in sections.items():
        for key, _ in items(section) if known[name] and own else ():
            if key in own and key not in known[name] and key not in _OF_ALL:
                message = f"'{node.name}' reads {key} of itself, not of its plugin '{name}'"
                yield Finding(key.span, message, f"write it next to {name}, not in it")
    for key, value in items(node.values) if own else ():
        readers = [name for name in known if key in known[name] and key not in sections[name]]
        is_lost = isinstance(value, Value | list) and key not in own
        if is_lost and len(readers) == 1:
            message = f"'{node.name}' reads {key} of its plugin '{readers[0]}', not of itself"
            yield Finding(key.span, message, f"move it into the section {readers[0]}")


def _with_commas(node: NodeParameters) -> Findings:
    """Commas in names of parameters, where a dot is meant."""
    for key, _ in entries(node.values):
        if re.fullmatch(r"\w+,\w+", key):
            message = f"'{node.name}': the name of the parameter '{key}' contains a comma"
            help = f"write {key.replace(',', '.')}"
            yield Finding(key.span, message, help)


def _meant(given: GivenValue) -> str | None:
    names = {name.rpartition(".")[2] for name in given.known}
    if given.at in names or not isinstance(given.value, Value | list):
        return None
    if given.at.startswith("_") and given.at[1:] in names:
        return given.at[1:]  # as on the command line of ROS 1
    suggested = nearest(given.at, names, CLOSE_TYPO) or next(
        (name for name in names if len(name) > 4 and is_typo(given.at, name)), None
    )
    is_other = suggested in given.siblings or (suggested and _is_of_other_axis(given.at, suggested))
    return None if is_other else suggested


def _is_of_other_axis(name: str, other: str) -> bool:
    """True for ``az_max`` and ``ay_max``, which differ in a short word."""
    pairs = zip(name.split("_"), other.split("_"), strict=False)
    return any(word != known and len(word) <= _SHORT >= len(known) for word, known in pairs)


def _without_inputs(context: Context) -> Findings:
    """Filters of robot_localization whose parameters name no input, mostly for lack of a file."""
    for node in context.launch.started if not context.launch.has_scopes else ():
        is_filter = node.package == "robot_localization" and node.executable in _FILTERS
        given = node.parameters.every if is_filter and node.is_ros_2 else None
        if given is not None and node.is_sure and not any(map(_INPUT.fullmatch, given)):
            message = f"'{node.title}' has no inputs: it gets no odom0, imu0 or the like"
            yield Finding(node.at, message, "load its parameter file")


def _unread_inputs(node: NodeParameters) -> Findings:
    """Inputs of robot_localization without the list of what is read of them, or the reverse."""
    if not any(CONFIGURATION.fullmatch(name) for name in node.values):
        return
    for name, _ in items(node.values):
        match = CONFIGURATION.fullmatch(name)
        if match and match[1] not in node.values:
            message = f"'{node.name}' does not read {name}: the topic {match[1]} is not given"
            yield Finding(name.span, message, f"add {match[1]}: TOPIC, or remove {name}")
    for name, value in items(node.values):
        is_input = _INPUT.fullmatch(name) and isinstance(value, Value)
        if not is_input or f"{name}_config" in node.values:
            continue
        others = [other for other in node.values if other.startswith(name) and other != name]
        yield Finding(
            name.span,
            f"'{node.name}': nothing of {name} is read: {name}_config is not given"
            f"{did_you_mean(f'{name}_config', others)}",
            f"add {name}_config with 15 booleans",
        )

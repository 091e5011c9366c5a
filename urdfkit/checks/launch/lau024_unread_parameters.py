"""Parameters of a node are not read, or it stops at them.

- A file of parameters names another node than the one that gets it (warning). ROS 2 reads what is
  below the name of the node, or below `/**`; the rest is ignored in silence, and the node runs by
  its defaults. The name is that which the launch file gives.
- `odom0_config` and its like have not 15 values: robot_localization reads five rows of three.
- A costmap names a plugin in `plugins` or `filters` for which there are no parameters: "Can not get
  'plugin' param value for voxel_layer". The same holds for `controller_plugins` and
  `planner_plugins`.
- `observation_sources` names a source without parameters (warning): the layer then listens to a
  topic of that name.
- A lifecycle manager waits for a node that nothing starts, or a node of Nav2 is started that no
  lifecycle manager activates (warning): it stays unconfigured.
- static_transform_publisher gets an option that it does not have, or another number of words: a
  period behind the frames belongs to ROS 1.

Sources:
    ROS 2, parameter files: https://docs.ros.org/en/rolling/How-To-Guides/Node-arguments.html
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    Nav2, lifecycle manager: https://docs.nav2.org/configuration/packages/configuring-lifecycle.html
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.checks.launch.lifecycle import not_activated
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.node_parameters import NodeParameters, node_parameters
from urdfkit.ros.launch.transforms import mistakes
from urdfkit.text.located_yaml import Key, Node, Value

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

#: Values of a row of robot_localization: position, angles, velocities, rates, accelerations.
_STATES = 15
_CONFIGURATION = re.compile(r"(odom|imu|pose|twist)\d+_config")
#: Lists of plugins, each with the value that needs no parameters.
_PLUGINS = {
    "plugins": ["static_layer", "obstacle_layer", "inflation_layer"],
    "filters": [],
    "controller_plugins": ["FollowPath"],
    "planner_plugins": ["GridBased"],
}
_COSTMAPS = ("local_costmap", "global_costmap")
#: Programs that hold nodes of other names.
_CONTAINERS = ("component_container", "gzserver", "gazebo", "ros2_control_node", "move_group")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    found: dict[str, list[NodeParameters]] = {}
    for file in context.launch.parameters:
        if file.exists and file.path not in found:
            try:
                found[file.path] = list(node_parameters(context.resolver.read(file.path)))
            except UnreadableFile:
                continue
    names = [one.name for several in found.values() for one in several]
    for several in found.values():
        for one in several:
            yield from _configurations(one)
            if names.count(one.name) == 1:  # others would complete it
                yield from _plugins(one)
    yield from _of_others(context, found)
    yield from not_activated(context)
    for started in context.launch.started:
        for word, message, help in mistakes(started):
            yield Finding(Location(word.span, started.frame), message, help)


def _configurations(node: NodeParameters) -> Findings:
    for key, value in node.values.items():
        if not isinstance(key, Key) or not _CONFIGURATION.fullmatch(key):
            continue
        if isinstance(value, list) and len(value) != _STATES:
            yield Finding(
                Location(key.span),
                f"'{node.name}': {key} has {len(value)} values, not {_STATES}",
                "write five rows: x y z, roll pitch yaw, their velocities, accelerations of x y z",
            )


def _plugins(node: NodeParameters) -> Findings:
    for key, defaults in _PLUGINS.items():
        if key in ("plugins", "filters") and node.name not in _COSTMAPS:
            continue
        listed = list(_words(node.values.get(key)))
        if [one.text for one in listed] == defaults:
            continue
        sections = {name for name, value in node.values.items() if isinstance(value, dict)}
        for one in listed:
            if one.text not in sections and f"{one.text}.plugin" not in node.values:
                yield Finding(
                    Location(one.span),
                    f"'{node.name}': no parameters for '{one.text}' of {key}"
                    f"{did_you_mean(one.text, sections)}",
                    f"add {one.text} with its plugin, or fix the name",
                )
    for layer in node.values.values():
        yield from _sources(layer) if isinstance(layer, dict) else ()


def _sources(layer: dict[str, Node]) -> Findings:
    given = layer.get("observation_sources")
    sections = {name for name, value in layer.items() if isinstance(value, dict)}
    for name in given.text.split() if isinstance(given, Value) else ():
        if isinstance(given, Value) and name not in sections:
            yield Finding(
                Location(given.span),
                f"observation source '{name}' has no parameters{did_you_mean(name, sections)}",
                f"add {name} with its topic and data_type, or fix the name",
                severity=Severity.WARNING,
            )


def _words(node: Node) -> Iterator[Value]:
    yield from (one for one in node if isinstance(one, Value)) if isinstance(node, list) else ()


def _of_others(context: Context, found: dict[str, list[NodeParameters]]) -> Findings:
    """The files whose parameters are those of another node than the one that gets them."""
    launch = context.launch
    started = (*launch.started, *launch.included)
    for path, several in found.items():
        users = [one for one in started if path in one.parameters.files]
        names = {one.name for one in several}
        is_known = users and all(map(_is_named, users)) and not launch.has_scopes
        if not names or not is_known or any("*" in name for name in names):
            continue
        if names.isdisjoint(one.name for one in users) and names.isdisjoint(_COSTMAPS):
            who = users[0]
            yield Finding(
                Location(several[0].at),
                f"parameters of '{several[0].name}' are not read: the node is called '{who.name}'",
                f"write {who.name}, or name the node {several[0].name}",
                related=(Related(who.span, "the node that gets the file"),),
                severity=Severity.WARNING,
            )


def _is_named(started: StartedProgram) -> bool:
    """True for one node of a known name."""
    return (
        bool(started.name)
        and started.namespace == ""
        and not any(started.executable.startswith(one) for one in _CONTAINERS)
    )

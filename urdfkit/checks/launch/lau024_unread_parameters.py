"""Parameters of a node are not read, or it stops at them.

- A file of parameters names another node than the one that gets it (warning). ROS 2 reads what is
  below the name of the node, or below `/**`; the rest is ignored in silence, and the node runs by
  its defaults. The name is that which the launch file gives, and in the namespace that it gives.
- `odom0_config` and its like have not 15 values: robot_localization reads five rows of three.
- A costmap names a plugin in `plugins` or `filters` for which there are no parameters: "Can not get
  'plugin' param value for voxel_layer". The same holds for `controller_plugins` and
  `planner_plugins`.
- A costmap's layer has a class that Nav2 does not have, or a `data_type` that it does not take.
- The parameters of a costmap are not below its name twice: `local_costmap: local_costmap:`.
- A whole number stands for a fraction, or the reverse: "expected [double] got [integer]". A list
  is in a list. A planner or controller of Nav2 is misspelt (warning).
- `observation_sources` names a source without parameters (warning): the layer then listens to a
  topic of that name.
- A lifecycle manager waits for a node that nothing starts, or a node of Nav2 is started that no
  lifecycle manager activates (warning): it stays unconfigured.
- A configuration of RViz has a display of a class that RViz 2 does not have, such as
  `rviz/LaserScan` of ROS 1 (warning): the display stays empty. Or it shows a robot whose meshes
  have relative names, or Gazebo's `model://`: "Could not load resource" (warning).
- A planning pipeline of MoveIt has no plugin (warning), neither in the file of MoveItConfigsBuilder
  nor in the dictionaries that the launch file hands to move_group
  ("Planning plugin name is empty or not defined in namespace 'ompl'"). Or
  `default_planning_pipeline` is none of `planning_pipelines` (warning; the builder stops). Or
  the solvers are not below `robot_description_kinematics` (warning).
- `robot_model_type` of AMCL is a name of ROS 1 (warning): Humble and later load a class.
- static_transform_publisher gets an option that it does not have, or another number of words: a
  period behind the frames belongs to ROS 1.

Sources:
    ROS 2, parameter files: https://docs.ros.org/en/rolling/How-To-Guides/Node-arguments.html
    robot_localization, state estimation: https://docs.ros.org/en/noetic/api/robot_localization/html/state_estimation_nodes.html
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    Nav2, lifecycle manager: https://docs.nav2.org/configuration/packages/configuring-lifecycle.html
"""

import re

from urdfkit.checks.launch.costmap_parameters import (
    COSTMAPS,
    misplaced,
    misspelt_servers,
    plugins,
)
from urdfkit.checks.launch.lifecycle import MANAGED, not_activated
from urdfkit.checks.launch.parameter_types import (
    old_model,
    whole_frequency,
    wrong_sizes,
    wrong_types,
)
from urdfkit.checks.launch.rviz_displays import relative_meshes, unknown_classes
from urdfkit.core.suggest import nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import (
    Context,
    Finding,
    Findings,
    Location,
    Need,
    Related,
    Severity,
    reported,
    rule,
)
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.node_parameters import NodeParameters, node_parameters
from urdfkit.ros.launch.transforms import mistakes
from urdfkit.text.located_yaml import Key

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
#: Programs that hold nodes of other names.
_CONTAINERS = ("component_container", "gzserver", "gazebo", "ros2_control_node", "move_group")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    paths = dict.fromkeys(file.path for file in context.launch.parameters if file.exists)
    sources = filter(None, map(context.resolver.readable, paths))
    found = {source.path: list(node_parameters(source)) for source in sources}
    names = [one.name for several in found.values() for one in several]
    for several in found.values():
        for one in several:
            yield from _configurations(one)
            yield from wrong_types(one)
            yield from old_model(one)
            yield from wrong_sizes(one)
            yield from misspelt_servers(one)
            if names.count(one.name) == 1:  # others would complete it
                yield from plugins(one)
                yield from misplaced(one)
    yield from _of_others(context, found)
    yield from not_activated(context)
    yield from unknown_classes(context)
    yield from relative_meshes(context)
    yield from reported(context, "LAU024")
    for started in context.launch.started:
        yield from _other_pipeline(started)
        yield from whole_frequency(started)
        for word, message, help in mistakes(started):
            yield Finding(Location(word.span, started.frame), message, help)


def _other_pipeline(started: StartedProgram) -> Findings:
    """A default of MoveIt's planning pipelines that is none of them."""
    name = started.parameters.values.get("default_planning_pipeline")
    loaded = started.parameters.lists.get("planning_pipelines", ())
    names = [one for one in loaded if one]
    if name and names and len(names) == len(loaded) and name not in names:
        yield Finding(
            Location(started.span, started.frame),
            f"default_planning_pipeline '{name}' is not in planning_pipelines: {few(names, 4)}",
            f"add '{name}' to planning_pipelines, with its settings",
            severity=Severity.WARNING,
        )


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


def _of_others(context: Context, found: dict[str, list[NodeParameters]]) -> Findings:
    """The files whose parameters are those of another node than the one that gets them."""
    launch = context.launch
    started = (*launch.started, *launch.included)
    for path, several in found.items():
        users = [one for one in started if path in one.parameters.files]
        names = {one.name for one in several}
        yield from _misnamed(several, users)
        if not launch.has_scopes:
            yield from _outside_namespace(several, users)
        is_known = users and all(map(_is_named, users)) and not launch.has_scopes
        if not names or not is_known or any("*" in name for name in names):
            continue
        if names.isdisjoint(one.name for one in users) and names.isdisjoint(COSTMAPS):
            who = users[0]
            likely = who.executable if who.executable in names else nearest(who.name, names)
            section = next((one for one in several if one.name == likely), several[0])
            yield Finding(
                Location(section.at),
                f"parameters of '{section.name}' are not read: the node is called '{who.name}'",
                f"write {who.name}, or name the node {section.name}",
                related=(Related(who.span, "the node that gets the file"),),
                severity=Severity.WARNING,
            )


def _outside_namespace(several: list[NodeParameters], users: list[StartedProgram]) -> Findings:
    """The sections of nodes that are started in a namespace, which the file does not write."""
    if any("*" in f"{one.namespace}/{one.name}" for one in several):
        return
    for one in several:
        owners = [user for user in users if _node_name(user) == one.name]
        written = {section.namespace.strip("/") for section in several if section.name == one.name}
        if owners and all(user.namespace and user.namespace not in written for user in owners):
            who = owners[0]
            yield Finding(
                Location(one.at),
                f"parameters of '{one.name}' are not read: the node is "
                f"'/{who.namespace}/{one.name}'",
                f"write the section below {who.namespace}:, or below /**:",
                related=(Related(who.span, "the node that gets the file"),),
                severity=Severity.WARNING,
            )


def _node_name(started: StartedProgram) -> str:
    """The name that a node has, or that it most likely gives itself."""
    is_manager = started.executable == "ros2_control_node"
    return started.name or ("controller_manager" if is_manager else started.executable)


def _misnamed(several: list[NodeParameters], users: list[StartedProgram]) -> Findings:
    """The sections that are meant for servers of Nav2 of similar names, which have none."""
    servers = {one.executable: one for one in users if one.executable in MANAGED and not one.name}
    lacking = servers.keys() - {one.name for one in several}
    for one in several:
        meant = nearest(one.name, lacking) if one.name not in servers else None
        if meant and meant.startswith(one.name.partition("_")[0]):
            yield Finding(
                Location(one.at),
                f"parameters of '{one.name}' are not read: the node is called '{meant}'",
                f"write {meant}",
                related=(Related(servers[meant].span, "the node that gets the file"),),
                severity=Severity.WARNING,
            )


def _is_named(started: StartedProgram) -> bool:
    """True for one node of a known name."""
    return (
        bool(started.name)
        and started.namespace == ""
        and not any(started.executable.startswith(one) for one in _CONTAINERS)
    )

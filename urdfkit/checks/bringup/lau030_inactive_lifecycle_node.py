"""A lifecycle node stays unconfigured, or what activates it waits for a node that is not started.

- A lifecycle manager of Nav2 waits for a node that nothing starts, or for one that is not a
  lifecycle node. Or `autostart` of the manager is false, as it is by default.
- No manager activates a node of Nav2, or of slam_toolbox since Jazzy, which stays unconfigured. Or
  no launch file of the workspace starts a lifecycle manager for a server of Nav2.
- A launch file of Nav2 waits for a container of composable nodes that nothing starts.

Sources:
    Nav2, lifecycle manager: https://docs.nav2.org/configuration/packages/configuring-lifecycle.html
    Nav2, lifecycle_manager.cpp: https://github.com/ros-navigation/navigation2/blob/main/nav2_lifecycle_manager/src/lifecycle_manager.cpp
    Nav2, navigation_launch.py: https://github.com/ros-navigation/navigation2/blob/main/nav2_bringup/launch/navigation_launch.py
    Managed nodes: https://design.ros2.org/articles/node_lifecycle.html
"""

import re
from collections.abc import Iterable

from urdfkit.checks.bringup.known_programs import are_topics_known
from urdfkit.checks.bringup.unread_commands import is_part_of_ros
from urdfkit.checks.bringup.workspace_launches import (
    all_launches,
    is_included,
    programs_of,
    workspace_launches,
)
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.workspace.program_strings import strings_in_programs
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "launch/navigation.launch.xml"
BAD = """\
<launch>
  <node pkg="nav2_map_server" exec="map_server" name="map_server"/>
  <node pkg="nav2_lifecycle_manager" exec="lifecycle_manager" name="manager">
    <param name="node_names" value="['map_server']"/>
    <param name="autostart" value="false"/>
  </node>
</launch>
"""
GOOD = BAD.replace('value="false"', 'value="true"')

_PACKAGE, _STARTING = "/nav2_bringup/launch/", "bringup_launch.py"
_LOADING = ("navigation_launch.py", "localization_launch.py")
_SWITCH, _NAME, _DEFAULT = "use_composition", "container_name", "nav2_container"
_MANAGER = "nav2_lifecycle_manager"
_NAMES, _AUTOSTART = "node_names", "autostart"
#: The service of a lifecycle manager that starts its nodes.
_SERVICE = "manage_nodes"
#: The switch of a node of Jazzy and later that activates itself.
_OF_NODE = "autostart_node"
_SLAM = "slam_toolbox"
#: Its program that is a plain node.
_PLAIN = "merge_maps_kinematic"
#: What activates a lifecycle node in a launch file, or in a program.
_TRANSITIONS = re.compile(rb"(?i)lifecycle(?!_manager)|ChangeState|change_state")
_MAX_NAMED = 4


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from _wrong_node_names(context)
    yield from _unmanaged(context)
    yield from _without_autostart(context)
    yield from _inactive_slam(context)
    if are_topics_known(context):
        yield from _missing_container(context)


def _missing_container(context: Context) -> Findings:
    """Launch files of Nav2 that wait for a container that they do not start."""
    if is_included(context):
        return
    launches = all_launches(context)
    if any(map(_may_start_container, launches)) or b"omposableNodeContainer" in context.source.data:
        return
    for file in context.launch.includes:
        arguments = file.arguments or {}
        switch, name = arguments.get(_SWITCH), arguments.get(_NAME)
        is_composed = switch is not None and (switch.text or "").lower() == "true"
        if is_composed and file.is_sure and file.path.endswith(_LOADING) and _PACKAGE in file.path:
            container = _DEFAULT if name is None else name.text
            yield Finding(
                file.span,
                f"{file.path.rpartition('/')[2]} waits for the container '{container}', which "
                "nothing starts",
                f"include {_STARTING}, start a component_container of this name, or set "
                f"{_SWITCH} to False",
            )


def _may_start_container(launch: Launch) -> bool:
    starts = any(node.executable.startswith("component_container") for node in launch.programs)
    return starts or any(_STARTING in file.path for file in launch.includes)


def _wrong_node_names(context: Context) -> Findings:
    """Managed nodes that are not started or not lifecycle nodes, and those that are not managed."""
    launch = context.launch
    programs = launch.programs
    managers = [node for node in programs if node.package == _MANAGER]
    is_known = not launch.unread and all(node.is_sure or node.package for node in programs)
    if not managers or not is_known or b"omposable" in context.source.data:
        return
    is_part = is_included(context)
    others = workspace_launches(context) if is_part else ()
    names = _managed(launch, *others)
    nodes = {node.title: node for node in programs}
    if None in names or names.isdisjoint(nodes):
        return
    yield from _not_managed(nodes, names)
    if not all(node.is_sure for node in programs):
        return
    yield from _without_lifecycle(nodes, names)
    started = {*nodes, *(node.title for node in programs_of(others))}
    own = (name for name in _managed(launch) if name and name not in started)
    missing = sorted(own) if _are_known(others) else []
    if missing:
        yield Finding(
            managers[0].at,
            f"the lifecycle manager waits for {few(missing, _MAX_NAMED)}, which nothing starts",
            f"start them, or remove them from {_NAMES}",
        )


def _not_managed(nodes: dict[str, StartedProgram], managed: set[str | None]) -> Findings:
    """Lifecycle nodes of Nav2 that no manager has in its list."""
    executables = data("nodes")["lifecycle"].split()
    for name, node in nodes.items():
        is_of_nav2 = node.package.startswith("nav2_") and node.executable in executables
        if is_of_nav2 and node.is_sure and name not in managed:
            yield Finding(
                node.at,
                f"'{name}' stays unconfigured: no lifecycle manager has it in {_NAMES}",
                f"add it to {_NAMES} of the lifecycle manager",
            )


def _without_lifecycle(nodes: dict[str, StartedProgram], managed: set[str | None]) -> Findings:
    """Managed nodes that are not lifecycle nodes."""
    for name in sorted(filter(None, managed.intersection(nodes))):
        node = nodes[name]
        if f"{node.package}/{node.executable}" in data("nodes")["plain"].split():
            yield Finding(
                node.at,
                f"the lifecycle manager waits for '{name}' for ever, which is not a lifecycle node",
                f"remove it from {_NAMES}",
            )


def _managed(*launches: Launch) -> set[str | None]:
    """The names in the lists of lifecycle managers, without their namespaces.

    None is among them if one is unknown.
    """
    return {
        name and name.rpartition("/")[2]
        for launch in launches
        for node in launch.programs
        if node.package == _MANAGER
        for name in node.parameters.lists.get(_NAMES, (None,))
    }


def _are_known(launches: Iterable[Launch]) -> bool:
    """True if they include no launch files that are not known, except those of ROS."""
    return all(is_part_of_ros(path) for launch in launches for path in launch.unread)


def _unmanaged(context: Context) -> Findings:
    """Servers of Nav2 in a workspace without lifecycle managers, which activates nothing itself."""
    may_change = _TRANSITIONS.search(context.source.data) or b"omposable" in context.source.data
    servers = data("nodes")["lifecycle"].split() if not may_change else ()
    for node in context.launch.started:
        is_server = node.executable in servers and node.is_sure and node.package.startswith("nav2_")
        switch = given_parameter(node, _OF_NODE, context.resolver) if is_server else None
        if switch is None or switch.lower() not in ("", "false"):
            continue
        if _may_be_managed(all_launches(context)):
            return
        yield Finding(
            node.at,
            f"'{node.title}' stays unconfigured: no launch file of the workspace starts a "
            "lifecycle manager",
            f"start {_MANAGER}, with {_AUTOSTART}, and with {node.title} in {_NAMES}",
        )


def _may_be_managed(launches: tuple[Launch, ...]) -> bool:
    """True if a manager is started, or a program that may activate nodes."""
    known = {name.partition("/")[0] for name in data("nodes")["publishers"]}
    packages = {node.package for node in programs_of(launches)}
    includes_nav2 = any("nav2" in path for launch in launches for path in launch.unread)
    are_of_ros = all(package in known or comes_with_ros(package) for package in packages)
    return _MANAGER in packages or includes_nav2 or not are_of_ros or not _are_known(launches)


def _without_autostart(context: Context) -> Findings:
    """Lifecycle managers that wait for somebody to start their nodes."""
    for node in context.launch.started if not context.launch.has_scopes else ():
        text = given_parameter(node, _AUTOSTART, context.resolver)
        is_manager = node.package == _MANAGER and node.is_sure
        is_off = is_manager and text is not None and text.lower() in ("", "false")
        if is_off and not _has_client(node, context):
            is_default = " by default" if not text else ""
            yield Finding(
                node.at,
                f"the nodes stay unconfigured: {_AUTOSTART} of the lifecycle manager is false"
                f"{is_default}",
                f"set {_AUTOSTART}: true",
            )


def _has_client(manager: StartedProgram, context: Context) -> bool:
    """True if the launch file, or a program of the workspace, names the manager's service."""
    if _SERVICE.encode() in context.source.data:
        return True
    names = (manager.title, f"{manager.title}/{_SERVICE}")
    return bool(strings_in_programs(names, context.source.path, context.resolver))


def _inactive_slam(context: Context) -> Findings:
    """Nodes of slam_toolbox that nothing activates, as is necessary since Jazzy."""
    started = (node for node in context.launch.started if node.executable != _PLAIN)
    nodes = [node for node in started if node.package == _SLAM and node.is_sure]
    if not nodes or not is_for_jazzy(context.source.path, context.resolver):
        return
    managed = _managed(*workspace_launches(context))
    for node in nodes if not _TRANSITIONS.search(context.source.data) else ():
        if managed.isdisjoint((None, node.name or _SLAM)):
            yield Finding(
                node.at,
                f"'{node.executable}' of Jazzy and later is a lifecycle node, which nothing "
                "activates: it publishes no map",
                "include online_async_launch.py of slam_toolbox, or add it to a lifecycle manager",
            )

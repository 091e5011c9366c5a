"""Plugins, polygons, critics and sources in the parameters of Nav2 that a node cannot load.

Sources: the plugins of ros-navigation/navigation2, humble to rolling: ``dwb_local_planner.cpp``,
``critic_manager.cpp``, ``nav2_rotation_shim_controller``, ``collision_monitor_node.cpp``,
``polygon.cpp``, ``waypoint_follower.cpp``, ``dock_database.cpp``; ``bt_action_server_impl.hpp``.
"""

from __future__ import annotations

import os

from urdfkit.core.suggest import TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import plugin_class
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value, mapping, scalar, scalars

_TREES = ("default_nav_to_pose_bt_xml", "default_nav_through_poses_bt_xml")
_BEHAVIORS, _TREE = "behavior_plugins", b"bt_xml"
_CRITICS = "critics"
#: Least similarity of a misspelt critic: ObstacleCritic is ObstaclesCritic.
_MIN_SIMILARITY = 0.8
#: Frames of localization that have the name of the other one.
_SWAPPED = {
    "odom_frame_id": "map",
    "odom_frame": "map",
    "global_frame_id": "odom",
    "map_frame": "odom",
}
_LOCALIZING = ("amcl", "slam_toolbox")


def unloadable_plugins(node: NodeParameters) -> Findings:
    """Names without parameters, and plugins without a parameter that they require."""
    yield from _names_without_section(node)
    for name, section in node.values.items():
        if isinstance(name, Key) and (kind := plugin_class(section)):
            yield from _incomplete(node, name, kind, mapping(section))
    yield from _relative_trees(node)
    yield from _swapped_frames(node)


def missing_in_default_trees(context: Context, sections: list[NodeParameters]) -> Findings:
    """What the default trees of the navigator call and no server offers."""
    navigators = [node for node in sections if node.name == "bt_navigator"]
    is_default = all(node.values.keys().isdisjoint(_TREES) for node in navigators)
    if len(navigators) != 1 or not is_default or _TREE in context.source.data:
        return
    called: dict[str, str] = data("nodes")["default_trees"]
    for parameter, names in called.items():
        servers = [node for node in sections if parameter in node.values]
        listed = scalars(servers[0].values[parameter]) if len(servers) == 1 else []
        missing = [name for name in names.split() if name not in {value.text for value in listed}]
        if listed and missing:
            stops = "stops" if parameter == _BEHAVIORS else "aborts its goals"
            yield Finding(
                listed[0].span,
                f"'bt_navigator' {stops}: its default behaviour tree calls '{missing[0]}', which "
                f"is not in {parameter}",
                f"add {missing[0]}, or set {_TREES[0]} to a tree without it",
                severity=Severity.WARNING,
            )


def _names_without_section(node: NodeParameters) -> Findings:
    """Names in a list of a node that has no section for them."""
    named: dict[str, str] = data("node_parameters")["sections"].get(node.name, {})
    sections = {str(key) for key, value in node.values.items() if isinstance(value, dict)}
    for key, default in named.items():
        value = node.values.get(key)
        for name in [value] if isinstance(value, Value) else scalars(value):
            is_given = name.text in sections or any(
                parameter.startswith(f"{name.text}.") for parameter in node.values
            )
            if name.text and name.text != default and not is_given and "$" not in name.text:
                yield Finding(
                    name.span,
                    f"'{node.name}': no parameters for '{name.text}' of {key}"
                    f"{did_you_mean(name.text, sections)}",
                    f"add {name.text} with its parameters, or fix the name",
                )


def _incomplete(node: NodeParameters, name: Key, kind: str, section: dict[str, Node]) -> Findings:
    for parameter in data("node_parameters")["required_of_plugins"].get(kind, "").split():
        if not any(key == parameter or key.startswith(f"{parameter}.") for key in section):
            message = f"'{node.name}' stops: {kind} requires {parameter}, which '{name}' lacks"
            yield Finding(name.span, message, f"add {parameter}")
    known = data("node_parameters")["critics"].get(kind, "").split()
    for critic in scalars(section.get(_CRITICS)) if known else ():
        own = mapping(section.get(critic.text)).get("class")
        bare = critic.text.rpartition("/" if "/" in critic.text else "::")[2]
        suggested = bare if bare in known else nearest(bare, known, _MIN_SIMILARITY)
        if own is None and critic.text not in _with_suffix(known) and suggested:
            message = f"'{node.name}' stops: unknown critic '{critic.text}'; did you mean "
            yield Finding(critic.span, f"{message}'{suggested}'?", f"write {suggested}")
    listed = {value.text for value in scalars(section.get(_CRITICS))}
    for key, value in section.items() if known else ():
        suggested = nearest(key, listed - section.keys(), TYPO)
        if isinstance(value, dict) and isinstance(key, Key) and key not in known and suggested:
            message = f"'{node.name}': the parameters of '{key}' are not read: the critic is "
            yield Finding(
                key.span,
                f"{message}'{suggested}'",
                f"write {suggested}",
                severity=Severity.WARNING,
            )


def _with_suffix(critics: list[str]) -> set[str]:
    """The critics with and without their suffix: DWB adds it."""
    return {*critics, *(f"{critic}Critic" for critic in critics)}


def _relative_trees(node: NodeParameters) -> Findings:
    """Behaviour trees without a directory, which the navigator does not find."""
    for key in _TREES if node.name == "bt_navigator" else ():
        value = scalar(node.values, key)
        text = value.text if value else ""
        is_file = text.endswith(".xml") and "$" not in text
        if value and is_file and not os.path.isabs(text):
            yield Finding(
                value.span,
                f"'{node.name}' does not find '{text}': {key} is not the full path of a file",
                "write $(find-pkg-share PACKAGE)/PATH, or omit it for the default tree",
                severity=Severity.WARNING,
            )


def _swapped_frames(node: NodeParameters) -> Findings:
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

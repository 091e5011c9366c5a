"""The YAML files of MoveIt next to an SRDF: solvers, planners and controllers of its groups.

Source: ``moveit_configs_utils`` and ``moveit_simple_controller_manager`` of moveit2, the launch
files of the setup assistant of MoveIt 1.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.located_yaml import Key, Node, Value, entries, load, mapping, scalars
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

_OMPL = "ompl_planning.yaml"
#: Files with a section for each group, and the keys that identify such a section.
_OF_GROUPS = {
    "kinematics.yaml": ("kinematics_solver",),
    _OMPL: ("planner_configs", "default_planner_config", "projection_evaluator"),
}
_OF_CONTROLLERS = (
    "moveit_controllers.yaml",
    "simple_moveit_controllers.yaml",
    "fake_controllers.yaml",
)
#: The list of controllers in packages that were not written by the setup assistant.
_OF_ROS_1 = "controllers.yaml"
PIPELINES = (
    _OMPL,
    "chomp_planning.yaml",
    "pilz_industrial_motion_planner_planning.yaml",
    "stomp_planning.yaml",
)
_INITIAL = "initial_positions.yaml"
#: Keys of MoveIt Servo's file, whose name differs from robot to robot; one of the second is enough.
_TOPIC_OF_SERVO = b"command_out_topic:"
_OF_SERVO = (b"move_group_name:", b"command_in_type:", b"command_out_type:", b"publish_period:")
MANAGER = "moveit_simple_controller_manager"
#: First characters of values that only launch or a template resolves.
_OPEN = ("$", "<", "{")


class GroupEntry(Record):
    """The section of a planning group in a file."""

    name: Key  # of the group
    values: dict[str, Node]  # of its section, by name
    is_alone: bool  # True if its file has no other group


def group_entries(srdf: Srdf, resolver: Resolver) -> Iterator[GroupEntry]:
    """The sections of planning groups in all files."""
    for file, marks in _OF_GROUPS.items():
        sections = [
            (key, node)
            for key, node in _mappings(_groups(load_next_to(srdf, file, resolver)))
            if not node.keys().isdisjoint(marks) and not key.startswith(_OPEN)
        ]
        for key, node in sections:
            yield GroupEntry(key, node, len(sections) == 1)


def _groups(root: dict[str, Node]) -> dict[str, Node]:
    """The sections of groups, which a launch file may also load as the parameters of all nodes."""
    parameters = _parameters(root)
    return mapping(parameters, "robot_description_kinematics") or parameters


def _parameters(root: dict[str, Node]) -> dict[str, Node]:
    """The parameters in a parameter file of ROS 2; any other file as it is."""
    nodes = (mapping(node, "ros__parameters") for _, node in _mappings(root))
    return next(filter(None, nodes), root)


def planner_entries(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[Value, list[str]]]:
    """The planners that groups reference in the OMPL file, with the planners that it defines."""
    root = load_next_to(srdf, _OMPL, resolver)
    defined = [str(key) for key in mapping(root, "planner_configs")]
    for key, group in _mappings(root):
        named = [group.get("default_planner_config"), *scalars(group.get("planner_configs"))]
        for value in named if key != "planner_configs" else ():
            if isinstance(value, Value) and value.text and not value.text.startswith(_OPEN):
                yield value, defined


def planning_plugins(srdf: Srdf, resolver: Resolver) -> Iterator[Value]:
    """The plugins of the planning pipelines in the files of pipelines such as OMPL."""
    for file in PIPELINES:
        root = load_next_to(srdf, file, resolver)
        for value in (root.get("planning_plugin"), *scalars(root.get("planning_plugins"))):
            if isinstance(value, Value):
                yield value


def adapters(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[str, str, Value, bool]]:
    """The adapters of the planning pipelines: key, name, location, and whether of Jazzy.

    From Jazzy on, the file has a list of planning plugins.
    """
    for file in PIPELINES:
        root = load_next_to(srdf, file, resolver)
        for key in ("request_adapters", "response_adapters"):
            node = root.get(key)
            for value in [node] if isinstance(node, Value) else scalars(node):
                for name in value.text.split():
                    yield key, name, value, "planning_plugins" in root


def joint_entries(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[str, Value]]:
    """Joint references in the files, each with a description of its owner."""
    for name, section in controllers(srdf, resolver):
        for joint in scalars(section.get("joints")):
            if not joint.text.startswith(_OPEN):
                yield f"controller '{name}'", joint
    for _, positions in _mappings(load_next_to(srdf, _INITIAL, resolver)):
        for key in positions:
            if isinstance(key, Key) and not key.startswith(_OPEN):
                yield _INITIAL, key.at


def controllers(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[str, dict[str, Node]]]:
    """The controllers to which MoveIt sends trajectories, with their settings."""
    for file in _OF_CONTROLLERS:
        root = load_next_to(srdf, file, resolver)
        managers = [root] if _is_manager(root) else [node for _, node in _mappings(root)]
        for manager in managers:
            yield from _mappings(manager)
    for file in (*_OF_CONTROLLERS, _OF_ROS_1):
        listed = load_next_to(srdf, file, resolver).get("controller_list")
        for item in listed if isinstance(listed, list) else ():
            if isinstance(name := mapping(item).get("name"), Value):
                yield name.text, mapping(item)


def controller_entries(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[Key, dict[str, Node]]]:
    """The settings of the controllers of MoveIt 2, by name with location."""
    for key, entry in _mappings(_manager(load_next_to(srdf, _OF_CONTROLLERS[0], resolver))):
        if not key.startswith(_OPEN):
            yield key, entry


def _manager(root: dict[str, Node]) -> dict[str, Node]:
    """The settings of the manager; launch files of their own pass a whole file as its settings."""
    return root if _is_manager(root) else mapping(_parameters(root), MANAGER)


def _is_manager(root: dict[str, Node]) -> bool:
    """True if the whole file is the settings; next to a section of them, the list is not read."""
    return MANAGER not in root and isinstance(root.get("controller_names"), list)


def controller_manager(srdf: Srdf, resolver: Resolver) -> Value | None:
    """MoveIt 2's controller manager plugin."""
    plugin = load_next_to(srdf, _OF_CONTROLLERS[0], resolver).get("moveit_controller_manager")
    return plugin if isinstance(plugin, Value) else None


def misplaced_controllers(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[Key, str]]:
    """Sections with controller names in a file without the section that is read, and its name."""
    root = load_next_to(srdf, _OF_CONTROLLERS[0], resolver)
    if MANAGER not in root:
        for key, section in _mappings(root):
            if isinstance(section.get("controller_names"), list) and "ros__parameters" not in root:
                yield key, MANAGER


def names_without_settings(
    srdf: Srdf, resolver: Resolver
) -> Iterator[tuple[Value, list[str], bool]]:
    """Names of controllers without settings, with the names of those with settings.

    The third item is True if the settings are in the file, but not below the manager.
    """
    root = load_next_to(srdf, _OF_CONTROLLERS[0], resolver)
    manager = _manager(root)
    configured = [str(key) for key, _ in _mappings(manager)]
    for name in scalars(manager.get("controller_names")):
        if name.text not in configured and not name.text.startswith(_OPEN):
            yield name, configured, name.text in root


def servo_values(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[Source, dict[str, Value]]]:
    """The files of MoveIt Servo next to an SRDF, and their values by key."""
    directory = os.path.dirname(os.path.abspath(srdf.path))
    for name in sorted(disk.names(directory)) if disk.is_directory(directory) else ():
        path = os.path.join(directory, name)
        source = resolver.readable(path) if name.endswith((".yaml", ".yml")) else None
        if source is None or _TOPIC_OF_SERVO not in source.data:
            continue
        if not any(key in source.data for key in _OF_SERVO):
            continue
        values = {
            str(key): node
            for key, node in entries(load(source))
            if isinstance(node, Value) and not node.text.startswith(_OPEN)
        }
        yield source, values


def _mappings(node: dict[str, Node]) -> Iterator[tuple[Key, dict[str, Node]]]:
    for key, inner in node.items():
        if isinstance(key, Key) and isinstance(inner, dict):
            yield key, inner


def load_next_to(srdf: Srdf, name: str, resolver: Resolver) -> dict[str, Node]:
    """A YAML file next to an SRDF or in its MoveIt configuration; empty if it is missing."""
    directory = os.path.dirname(os.path.abspath(srdf.path))
    above = os.path.dirname(directory)
    for place in (directory, above, os.path.join(above, "config")):
        path = os.path.join(place, name)
        if disk.is_file(path) and resolver.allows(path, srdf.path):
            try:
                return mapping(load(resolver.read(path)))
            except UrdfkitError:
                return {}
    return {}

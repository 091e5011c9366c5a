"""The YAML files of MoveIt next to an SRDF: solvers, planners and controllers of its groups.

Source: ``moveit_configs_utils`` and ``moveit_simple_controller_manager`` of moveit2, the launch
files of the setup assistant of MoveIt 1.
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.text.located_yaml import (
    TEMPLATE_MARKS,
    Key,
    Node,
    Value,
    entries,
    items,
    load,
    mapping,
    scalars,
    syntax_error,
)
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

_OMPL = "ompl_planning.yaml"
#: Files with a section for each group, and the keys that identify such a section.
_OF_GROUPS = {
    "kinematics.yaml": ("kinematics_solver",),
    _OMPL: ("planner_configs", "default_planner_config", "projection_evaluator"),
}
CONTROLLERS = "moveit_controllers.yaml"
_OF_CONTROLLERS = (CONTROLLERS, "simple_moveit_controllers.yaml", "fake_controllers.yaml")
#: The list of controllers in packages that were not written by the setup assistant.
_OF_ROS_1 = "controllers.yaml"
PIPELINES = (
    _OMPL,
    "chomp_planning.yaml",
    "pilz_industrial_motion_planner_planning.yaml",
    "stomp_planning.yaml",
)
#: As MoveItConfigsBuilder finds them, and ``moveit_planning.yaml`` in launch files without it.
_OF_PIPELINES = "_planning.yaml"
_INITIAL = "initial_positions.yaml"
#: The files that MoveIt loads by their names, besides those of pipelines.
_FILES = (*_OF_GROUPS, *_OF_CONTROLLERS, "joint_limits.yaml", "sensors_3d.yaml", _INITIAL)
#: Keys of MoveIt Servo's file, whose name differs from robot to robot; one of the second is enough.
_TOPIC_OF_SERVO = b"command_out_topic:"
_OF_SERVO = (b"move_group_name:", b"command_in_type:", b"command_out_type:", b"publish_period:")
MANAGER = "moveit_simple_controller_manager"


class GroupEntry(Record):
    """The section of a planning group in a file."""

    name: Key  # of the group
    values: dict[str, Node]  # of its section, by name
    is_alone: bool  # True if its file has no other group


class MoveItConfig:
    """The configuration of MoveIt for an SRDF; each file is read once.

    Args:
        srdf: path of the SRDF.
    """

    def __init__(self, srdf: str, resolver: Resolver) -> None:
        self._path = srdf
        self._directory = os.path.dirname(os.path.abspath(srdf))
        self._resolver = resolver
        self._files: dict[str, dict[str, Node]] = {}

    def load(self, name: str) -> dict[str, Node]:
        """A YAML file next to the SRDF or in its MoveIt configuration; empty if it is missing."""
        if name not in self._files:
            self._files[name] = self._read(name)
        return self._files[name]

    def parameter(self, file: str, name: str) -> dict[str, Node]:
        """The contents of a file, which may be a parameter in a file for nodes."""
        parameters = _parameters(self.load(file))
        return mapping(parameters, name) or parameters

    def pipelines(self) -> Iterator[dict[str, Node]]:
        """The files of planning pipelines such as OMPL, which are known by their ending."""
        for name in self._names(_OF_PIPELINES):
            yield self.load(name)

    def _names(self, *endings: str) -> list[str]:
        """The names of files in its directories."""
        names = (name for place in self._places for name in disk.names_or_empty(place))
        return sorted({name for name in names if name.endswith(endings)})

    def syntax_errors(self) -> Iterator[tuple[Span, str]]:
        """Location and message of the first syntax error of each file that is not YAML."""
        for name in self._names(_OF_PIPELINES, *_FILES):
            source = self._source(name)
            is_odd = source is not None and not isinstance(load(source), dict)
            if source and is_odd and (error := syntax_error(source, in_python=True)):
                yield error

    @property
    def _places(self) -> tuple[str, ...]:
        above = os.path.dirname(self._directory)
        return (self._directory, above, os.path.join(above, "config"))

    def _read(self, name: str) -> dict[str, Node]:
        source = self._source(name)
        return mapping(load(source)) if source else {}

    def _source(self, name: str) -> Source | None:
        for place in self._places:
            path = os.path.join(place, name)
            if disk.is_file(path) and self._resolver.allows(path, self._path):
                return self._resolver.readable(path)
        return None

    def group_entries(self) -> Iterator[GroupEntry]:
        """The sections of planning groups in all files."""
        for file, marks in _OF_GROUPS.items():
            sections = [
                (key, node)
                for key, node in _mappings(self.parameter(file, "robot_description_kinematics"))
                if not node.keys().isdisjoint(marks) and not key.startswith(TEMPLATE_MARKS)
            ]
            for key, node in sections:
                yield GroupEntry(key, node, len(sections) == 1)

    def planner_entries(self) -> Iterator[tuple[Value, list[str]]]:
        """The planners of groups in the OMPL file, each with the planners that it defines."""
        root = self.load(_OMPL)
        defined = [str(key) for key in mapping(root, "planner_configs")]
        for key, group in _mappings(root):
            named = [group.get("default_planner_config"), *scalars(group.get("planner_configs"))]
            planners = [value for value in named if isinstance(value, Value) and value.text]
            for planner in planners if key != "planner_configs" else ():
                if not planner.text.startswith(TEMPLATE_MARKS):
                    yield planner, defined

    def planning_plugins(self) -> Iterator[Value]:
        """The plugins of the planning pipelines in the files of pipelines such as OMPL."""
        for root in self.pipelines():
            for value in (root.get("planning_plugin"), *scalars(root.get("planning_plugins"))):
                if isinstance(value, Value):
                    yield value

    def adapters(self) -> Iterator[tuple[str, str, Value, bool]]:
        """The adapters of the planning pipelines: key, name, location, and whether of Jazzy.

        From Jazzy on, the file has a list of planning plugins.
        """
        for root in self.pipelines():
            for key in ("request_adapters", "response_adapters"):
                node = root.get(key)
                for value in [node] if isinstance(node, Value) else scalars(node):
                    for name in value.text.split():
                        yield key, name, value, "planning_plugins" in root

    def joint_entries(self) -> Iterator[tuple[str, Value]]:
        """Joint references in the files, each with a description of its owner."""
        for name, section in self.controllers():
            for joint in scalars(section.get("joints")):
                if not joint.text.startswith(TEMPLATE_MARKS):
                    yield f"controller '{name}'", joint
        for _, positions in _mappings(self.load(_INITIAL)):
            for key, _ in items(positions):
                if not key.startswith(TEMPLATE_MARKS):
                    yield _INITIAL, key.at

    def controllers(self) -> Iterator[tuple[str, dict[str, Node]]]:
        """The controllers to which MoveIt sends trajectories, with their settings."""
        for file in _OF_CONTROLLERS:
            root = self.load(file)
            managers = [root] if _is_manager(root) else [node for _, node in _mappings(root)]
            for manager in managers:
                yield from _mappings(manager)
        for file in (*_OF_CONTROLLERS, _OF_ROS_1):
            listed = self.load(file).get("controller_list")
            for item in listed if isinstance(listed, list) else ():
                if isinstance(name := mapping(item).get("name"), Value):
                    yield name.text, mapping(item)

    def controller_entries(self) -> Iterator[tuple[Key, dict[str, Node]]]:
        """The settings of the controllers of MoveIt 2, by name with location."""
        for key, entry in _mappings(_manager(self.load(CONTROLLERS))):
            if not key.startswith(TEMPLATE_MARKS):
                yield key, entry

    def controller_manager(self) -> Value | None:
        """MoveIt 2's controller manager plugin."""
        plugin = self.load(CONTROLLERS).get("moveit_controller_manager")
        return plugin if isinstance(plugin, Value) else None

    def misplaced_controllers(self) -> Iterator[Key]:
        """Sections with controller names in a file without the section of the manager."""
        root = self.load(CONTROLLERS)
        if MANAGER not in root and "ros__parameters" not in root:
            for key, section in _mappings(root):
                if isinstance(section.get("controller_names"), list):
                    yield key

    def names_without_settings(self) -> Iterator[tuple[Value, list[str], bool]]:
        """Names of controllers without settings, with the names of those with settings.

        The third item is True if the settings are in the file, but not below the manager.
        """
        root = self.load(CONTROLLERS)
        manager = _manager(root)
        configured = [str(key) for key, _ in _mappings(manager)]
        for name in scalars(manager.get("controller_names")):
            if name.text not in configured and not name.text.startswith(TEMPLATE_MARKS):
                yield name, configured, name.text in root

    def servo_values(self) -> Iterator[tuple[Source, dict[str, Value]]]:
        """The files of MoveIt Servo next to an SRDF, and their values by key."""
        directory = self._directory
        for name in sorted(disk.names_or_empty(directory)):
            path = os.path.join(directory, name)
            source = self._resolver.readable(path) if name.endswith((".yaml", ".yml")) else None
            if source is None or _TOPIC_OF_SERVO not in source.data:
                continue
            if not any(key in source.data for key in _OF_SERVO):
                continue
            values = {
                str(key): node
                for key, node in entries(load(source))
                if isinstance(node, Value) and not node.text.startswith(TEMPLATE_MARKS)
            }
            yield source, values


def _parameters(root: dict[str, Node]) -> dict[str, Node]:
    """The parameters in a parameter file of ROS 2; any other file as it is."""
    nodes = (mapping(node, "ros__parameters") for _, node in _mappings(root))
    return next(filter(None, nodes), root)


def _manager(root: dict[str, Node]) -> dict[str, Node]:
    """The settings of the manager; launch files of their own pass a whole file as its settings."""
    return root if _is_manager(root) else mapping(_parameters(root), MANAGER)


def _is_manager(root: dict[str, Node]) -> bool:
    """True if the whole file is the settings; next to a section of them, the list is not read."""
    return MANAGER not in root and isinstance(root.get("controller_names"), list)


def _mappings(node: dict[str, Node]) -> Iterator[tuple[Key, dict[str, Node]]]:
    for key, inner in items(node):
        if isinstance(inner, dict):
            yield key, inner

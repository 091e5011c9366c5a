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
from urdfkit.text.located_yaml import Key, Node, Value, load, mapping, scalars
from urdfkit.workspace.resolve import Resolver

_OMPL = "ompl_planning.yaml"
#: Files with a section for each group, and the keys by which one is known.
_OF_GROUPS = {
    "kinematics.yaml": ("kinematics_solver",),
    _OMPL: ("planner_configs", "default_planner_config", "projection_evaluator"),
}
_OF_CONTROLLERS = (
    "moveit_controllers.yaml",
    "simple_moveit_controllers.yaml",
    "fake_controllers.yaml",
)
_PIPELINES = (
    _OMPL,
    "chomp_planning.yaml",
    "pilz_industrial_motion_planner_planning.yaml",
    "stomp_planning.yaml",
)
_INITIAL = "initial_positions.yaml"
MANAGER = "moveit_simple_controller_manager"
#: What only launch or a template fills in.
_OPEN = ("$", "<", "{")


class GroupEntry(Record):
    """What a file says of a planning group."""

    name: Key  # of the group
    values: dict[str, Node]  # of its section, by name
    is_alone: bool  # True if its file speaks of no other group


def group_entries(srdf: Srdf, resolver: Resolver) -> Iterator[GroupEntry]:
    """The sections of planning groups, in the files that have some."""
    for file, marks in _OF_GROUPS.items():
        found = [
            (key, node)
            for key, node in _mappings(load_next_to(srdf, file, resolver))
            if not node.keys().isdisjoint(marks) and not key.startswith(_OPEN)
        ]
        for key, node in found:
            yield GroupEntry(key, node, len(found) == 1)


def planner_entries(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[Value, list[str]]]:
    """The planners that groups name in the file of OMPL, with those that it defines."""
    root = load_next_to(srdf, _OMPL, resolver)
    defined = [str(key) for key in mapping(root, "planner_configs")]
    for key, group in _mappings(root):
        named = [group.get("default_planner_config"), *scalars(group.get("planner_configs"))]
        for one in named if key != "planner_configs" else ():
            if isinstance(one, Value) and one.text and not one.text.startswith(_OPEN):
                yield one, defined


def planning_plugins(srdf: Srdf, resolver: Resolver) -> Iterator[Value]:
    """The plugins of the planning pipelines in the files of OMPL and the like."""
    for file in _PIPELINES:
        root = load_next_to(srdf, file, resolver)
        for one in (root.get("planning_plugin"), *scalars(root.get("planning_plugins"))):
            if isinstance(one, Value):
                yield one


def adapters(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[str, str, Value]]:
    """The adapters of the planning pipelines, by the keys that list them: key, name and place."""
    for file in _PIPELINES:
        root = load_next_to(srdf, file, resolver)
        for key in ("request_adapters", "response_adapters"):
            node = root.get(key)
            for value in [node] if isinstance(node, Value) else scalars(node):
                for name in value.text.split():
                    yield key, name, value


def joint_entries(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[str, Value]]:
    """The joints that the files name, each with who names it."""
    for name, section in controllers(srdf, resolver):
        for joint in scalars(section.get("joints")):
            if not joint.text.startswith(_OPEN):
                yield f"controller '{name}'", joint
    for _, positions in _mappings(load_next_to(srdf, _INITIAL, resolver)):
        for key in positions:
            if isinstance(key, Key) and not key.startswith(_OPEN):
                yield _INITIAL, key.at


def controllers(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[str, dict[str, Node]]]:
    """The controllers that MoveIt sends trajectories to, with their settings."""
    for file in _OF_CONTROLLERS:
        root = load_next_to(srdf, file, resolver)
        for _, manager in _mappings(root):
            yield from _mappings(manager)
        listed = root.get("controller_list")
        for item in listed if isinstance(listed, list) else ():  # in ROS 1
            if isinstance(name := mapping(item).get("name"), Value):
                yield name.text, mapping(item)


def controller_entries(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[Key, dict[str, Node]]]:
    """The settings of the controllers of MoveIt 2, by the places of their names."""
    for key, entry in _mappings(mapping(load_next_to(srdf, _OF_CONTROLLERS[0], resolver), MANAGER)):
        if not key.startswith(_OPEN):
            yield key, entry


def controller_manager(srdf: Srdf, resolver: Resolver) -> Value | None:
    """The plugin by which MoveIt 2 talks to controllers."""
    found = load_next_to(srdf, _OF_CONTROLLERS[0], resolver).get("moveit_controller_manager")
    return found if isinstance(found, Value) else None


def misplaced_controllers(srdf: Srdf, resolver: Resolver) -> Iterator[tuple[Key, str]]:
    """Sections with the names of controllers in a file without the one that is read, its name."""
    root = load_next_to(srdf, _OF_CONTROLLERS[0], resolver)
    if MANAGER not in root:
        for key, section in _mappings(root):
            if isinstance(section.get("controller_names"), list) and "ros__parameters" not in root:
                yield key, MANAGER


def names_without_settings(
    srdf: Srdf, resolver: Resolver
) -> Iterator[tuple[Value, list[str], bool]]:
    """The names of controllers for which there are no settings, with those that have some.

    True if the settings stand in the file, but not below the manager.
    """
    root = load_next_to(srdf, _OF_CONTROLLERS[0], resolver)
    manager = mapping(root, MANAGER)
    known = [str(key) for key, _ in _mappings(manager)]
    for name in scalars(manager.get("controller_names")):
        if name.text not in known and not name.text.startswith(_OPEN):
            yield name, known, name.text in root


def _mappings(node: dict[str, Node]) -> Iterator[tuple[Key, dict[str, Node]]]:
    for key, inner in node.items():
        if isinstance(key, Key) and isinstance(inner, dict):
            yield key, inner


def load_next_to(srdf: Srdf, name: str, resolver: Resolver) -> dict[str, Node]:
    """A YAML file next to an SRDF, or in the configuration that it is part of; else empty."""
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

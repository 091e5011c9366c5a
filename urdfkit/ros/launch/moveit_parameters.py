"""The parameters that Python launch files pass to move_group and RViz, as far as they are known.

Sources: ``planning_pipeline.cpp`` and ``kinematics_plugin_loader.cpp`` of moveit/moveit2.
"""

import ast
import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.errors import UrdfkitError
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.python_file import PythonLaunchFile
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.located_yaml import Node, load, mapping

#: The display of RViz that has interactive markers for the end effectors.
_DISPLAY = b"moveit_rviz_plugin/MotionPlanning"
_DESCRIPTION = "robot_description"
_SEMANTIC = "robot_description_semantic"
_KINEMATICS = "robot_description_kinematics"
_SOLVER = ".kinematics_solver"
#: Files whose content move_group needs, and what fails without it.
_SETTINGS = {
    _KINEMATICS: (b"kinematics.yaml", "no planning group has a solver"),
    "robot_description_planning": (b"joint_limits.yaml", "no joint has a limit of acceleration"),
}
#: Where Servo looks for its parameters, and one that each configuration has.
_SERVO, _GROUP = "moveit_servo", "move_group_name"
_OF_SERVO = re.compile(r"\w*servo\w*\.\*")
#: Statements that change a dictionary after its creation.
_CHANGES = re.compile(rb"\.update\(|\]\s*=[^=]|\|=")
_LOADS = ("safe_load", "load", "full_load")
#: Placeholder of unknown keys.
_OPEN = "*"


def missing_of_move_group(file: PythonLaunchFile, node: ast.Call) -> Iterator[Problem]:
    """Missing parameters of a ``Node`` with move_group; empty unless all parameters are known."""
    values = file.values
    if _CHANGES.search(file.source.data):
        return
    reader = _Reader(file)
    parameters = argument(node, None, "parameters")
    items = values.items(parameters) if parameters else []
    keys = {key for item in items for key in reader.keys(item)}
    if _OPEN in keys or any(keyword.arg is None for keyword in node.keywords):
        return
    has_no_other = all(key.startswith("use_sim_time") for key in keys)
    if _SEMANTIC not in keys and (_DESCRIPTION in keys or has_no_other):
        message = f"move_group gets no {_SEMANTIC}, and so no planning groups"
        help = f'add {{"{_SEMANTIC}": ...}} with the text of the SRDF'
        yield Problem("LAU029", values.span(node), message, help, severity=Severity.WARNING)
    if _SEMANTIC in keys:
        yield from _missing_settings(file, node, keys)
    for item in items:
        for name, place in reader.pipelines(item):
            plugins = (_OPEN, "planning_plugin", "planning_plugins")
            if keys.isdisjoint(f"{name}.{plugin}" for plugin in plugins):
                message = f"planning pipeline '{name}' has no planning plugin"
                help = f'add "{name}" with planning_plugins, as in {name}_planning.yaml'
                at = values.span(place)
                yield Problem("LAU029", at, message, help, severity=Severity.WARNING)
    if any(key.endswith(_SOLVER) and key.count(".") == 1 for key in keys):
        message = (
            f"the kinematics solvers are not in {_KINEMATICS}: from ROS 2 Iron on, no planning "
            "group has a solver"
        )
        help = f'write {{"{_KINEMATICS}": ...}} around them'
        # MoveIt of Humble, for which a launch file may be, reads them there as well.
        yield Problem("LAU029", values.span(node), message, help, severity=Severity.INFO)


def _missing_settings(file: PythonLaunchFile, node: ast.Call, keys: set[str]) -> Iterator[Problem]:
    """Settings that the launch file mentions and move_group does not get."""
    is_open = any(key.endswith(_SOLVER) for key in keys)  # as in Humble
    for name, (file_name, lost) in _SETTINGS.items():
        is_given = name in keys or (is_open and name == _KINEMATICS)
        if not is_given and file_name in file.source.data:
            message = f"move_group gets no {name}: {lost}"
            help = f"add {name} with {file_name.decode()} to its parameters"
            at = file.values.span(node)
            yield Problem("LAU029", at, message, help, severity=Severity.WARNING)


def missing_of_rviz(file: PythonLaunchFile, node: ast.Call) -> Iterator[Problem]:
    """An RViz that gets the planning groups and not their solvers."""
    values = file.values
    words = [values.text(word) or "" for word in values.items(argument(node, None, "arguments"))]
    path = next((word for word in words if word.endswith(".rviz")), "")
    configuration = file.collector.resolver.readable(path) if os.path.isabs(path) else None
    is_planner = configuration is not None and _DISPLAY in configuration.data
    if not is_planner or _CHANGES.search(file.source.data):
        return
    parameters = argument(node, None, "parameters")
    items = values.items(parameters) if parameters else []
    names = set().union(*(_keys_of_part(file, item) for item in items))
    if _OPEN not in names and _SEMANTIC in names and _KINEMATICS not in names:
        message = f"RViz has {_SEMANTIC}, but not {_KINEMATICS}: its MotionPlanning has no markers"
        help = f"add {_KINEMATICS} to its parameters"
        yield Problem("LAU029", values.span(node), message, help, severity=Severity.WARNING)


def missing_of_servo(file: PythonLaunchFile, node: ast.Call) -> Iterator[Problem]:
    """A Servo whose parameters are in another namespace."""
    parameters = argument(node, None, "parameters")
    if _CHANGES.search(file.source.data) or parameters is None:
        return
    items = [item for item in file.values.items(parameters) if item is not None]
    keys = set().union(*(_keys_of_part(file, item) for item in items))
    names = {key.partition(".")[0] for key in keys}
    # The content of what is called after Servo need not be known.
    inner = [key for key in sorted(keys) if key.endswith(_GROUP) or _OF_SERVO.fullmatch(key)]
    if _OPEN not in names and _SERVO not in names and inner:
        message = f"Servo reads its parameters in {_SERVO}, which is not given"
        help = f"write {_SERVO} in place of {inner[0].rpartition('.')[0] or 'the top level'}"
        yield Problem("LAU029", file.values.span(node), message, help, severity=Severity.WARNING)


def _keys_of_part(file: PythonLaunchFile, item: ast.expr | None) -> set[str]:
    """Names of parameters; an attribute of a configuration of MoveIt is called after its own."""
    part = file.values.resolved(item)
    return {part.attr} if isinstance(part, ast.Attribute) else _Reader(file).keys(item)


class _Reader:
    """Reads names in dictionaries, and in YAML files that a function of the launch file loads."""

    def __init__(self, file: PythonLaunchFile) -> None:
        self._values = file.values
        self._resolver = file.collector.resolver
        self._functions = {
            node.name
            for node in file.tree.body
            if isinstance(node, ast.FunctionDef)
            and any(called(n) in _LOADS for n in ast.walk(node))
        }

    def keys(self, node: ast.expr | None) -> set[str]:
        """The names of parameters, with dots between levels."""
        node = self._values.resolved(node)
        if isinstance(node, ast.Dict):
            names: set[str] = set()
            for key, value in self._values.pairs(node):
                name = self._values.text(key)
                if name is None:
                    return {_OPEN}
                names |= {name, *(f"{name}.{inner}" for inner in self.keys(value))}
            return names
        root = self._loaded(node) if isinstance(node, ast.Call) else None
        if root is None:
            return {_OPEN}
        nested = {f"{key}.{inner}" for key, value in root.items() for inner in mapping(value)}
        return {*map(str, root), *nested}

    def pipelines(self, node: ast.expr | None) -> Iterator[tuple[str, ast.expr]]:
        """The names in a list of planning pipelines, with their locations."""
        for key, value in self._values.pairs(node):
            is_pipelines = self._values.text(key) == "planning_pipelines"
            for item in self._values.items(value) if is_pipelines else ():
                if item is not None and (name := self._values.text(item)):
                    yield name, item

    def _loaded(self, call: ast.Call) -> dict[str, Node] | None:
        """The YAML that a function of the launch file reads from a path, or a path in a package."""
        texts = [self._values.text(argument) for argument in call.args]
        if called(call) not in self._functions or call.keywords or None in texts:
            return None
        parts = [text or "" for text in texts]
        try:
            if len(parts) == 2:
                parts[0] = self._resolver.package(parts[0], self._values.source.path)
            path = os.path.join(*parts) if parts else ""
            if not os.path.isabs(path) or not disk.is_file(path):
                return None
            return mapping(load(self._resolver.read(path)))
        except UrdfkitError:
            return None

"""Parameters in dictionaries that a launch file passes to move_group, as in MoveIt's tutorials.

Source: ``planning_pipeline.cpp`` and ``kinematics_plugin_loader.cpp`` of moveit/moveit2.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.errors import UrdfkitError
from urdfkit.ros.launch.collect import Collector
from urdfkit.ros.launch.values import Values, argument, called
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.located_yaml import Node, load, mapping

_KINEMATICS = "robot_description_kinematics"
_SOLVER = ".kinematics_solver"
#: Statements that change a dictionary after its creation.
_CHANGES = re.compile(rb"\.update\(|\]\s*=[^=]|\|=")
_LOADS = ("safe_load", "load", "full_load")
#: Placeholder of unknown keys.
_OPEN = "*"


def problems(
    node: ast.Call, tree: ast.Module, values: Values, collector: Collector
) -> Iterator[Problem]:
    """Missing parameters of a ``Node`` with move_group; empty unless all parameters are known."""
    if _CHANGES.search(values.source.data):
        return
    reader = _Reader(tree, values, collector)
    parameters = argument(node, None, "parameters")
    items = values.items(parameters) if parameters else [None]
    keys = {key for item in items for key in reader.keys(item)}
    if _OPEN in keys:
        return
    for item in items:
        for name, place in reader.pipelines(item):
            plugins = (_OPEN, "planning_plugin", "planning_plugins")
            if not keys.isdisjoint(f"{name}.{plugin}" for plugin in plugins):
                continue
            message = f"planning pipeline '{name}' has no planning plugin"
            help = f'add "{name}" with planning_plugins, as in {name}_planning.yaml'
            yield Problem("LAU024", values.span(place), message, help, severity=Severity.WARNING)
    if any(key.endswith(_SOLVER) and key.count(".") == 1 for key in keys):
        message = (
            f"the kinematics solvers are not in {_KINEMATICS}, so no planning group has a solver"
        )
        help = f'write {{"{_KINEMATICS}": ...}} around them'
        yield Problem("LAU024", values.span(node), message, help, severity=Severity.WARNING)


class _Reader:
    """Reads names in dictionaries, and in YAML files that a function of the launch file loads."""

    def __init__(self, tree: ast.Module, values: Values, collector: Collector) -> None:
        self._values = values
        self._resolver = collector.resolver
        self._functions = {
            node.name
            for node in tree.body
            if isinstance(node, ast.FunctionDef)
            and any(isinstance(n, ast.Call) and called(n) in _LOADS for n in ast.walk(node))
        }

    def keys(self, node: ast.expr | None) -> set[str]:
        """The names of parameters, with dots between levels."""
        node = self._values.suggested(node)
        if isinstance(node, ast.Dict):
            names: set[str] = set()
            for key, value in zip(node.keys, node.values, strict=True):
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
        dictionary = self._values.suggested(node)
        pairs = (
            zip(dictionary.keys, dictionary.values, strict=True)
            if isinstance(dictionary, ast.Dict)
            else ()
        )
        for key, value in pairs:
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

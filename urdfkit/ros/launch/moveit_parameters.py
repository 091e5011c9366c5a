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
    given = argument(node, None, "parameters")
    items = values.items(given) if given else [None]
    keys = {key for item in items for key in reader.keys(item)}
    if _OPEN in keys:
        return
    for item in items:
        for name, place in reader.pipelines(item):
            known = (_OPEN, "planning_plugin", "planning_plugins")
            if not keys.isdisjoint(f"{name}.{one}" for one in known):
                continue
            message = f"planning pipeline '{name}' gets no planning plugin"
            help = f'add "{name}" with planning_plugins, as in {name}_planning.yaml'
            yield Problem("LAU024", values.span(place), message, help, severity=Severity.WARNING)
    if any(key.endswith(_SOLVER) and key.count(".") == 1 for key in keys):
        message = f"the solvers of MoveIt are not in {_KINEMATICS}, so no group has one"
        help = f'write {{"{_KINEMATICS}": ...}} around them'
        yield Problem("LAU024", values.span(node), message, help, severity=Severity.WARNING)


class _Reader:
    """Reads names in dictionaries, and in YAML files that a function of the launch file loads."""

    def __init__(self, tree: ast.Module, values: Values, collector: Collector) -> None:
        self._values = values
        self._resolver = collector.resolver
        self._functions = {
            one.name
            for one in tree.body
            if isinstance(one, ast.FunctionDef)
            and any(isinstance(n, ast.Call) and called(n) in _LOADS for n in ast.walk(one))
        }

    def keys(self, node: ast.expr | None) -> set[str]:
        """The names of parameters, with dots between levels."""
        node = self._values.suggested(node)
        if isinstance(node, ast.Dict):
            found: set[str] = set()
            for key, value in zip(node.keys, node.values, strict=True):
                name = self._values.text(key)
                if name is None:
                    return {_OPEN}
                found |= {name, *(f"{name}.{inner}" for inner in self.keys(value))}
            return found
        root = self._loaded(node) if isinstance(node, ast.Call) else None
        if root is None:
            return {_OPEN}
        inside = {f"{key}.{one}" for key, value in root.items() for one in mapping(value)}
        return {*map(str, root), *inside}

    def pipelines(self, node: ast.expr | None) -> Iterator[tuple[str, ast.expr]]:
        """The names in a list of planning pipelines, with their locations."""
        given = self._values.suggested(node)
        pairs = zip(given.keys, given.values, strict=True) if isinstance(given, ast.Dict) else ()
        for key, value in pairs:
            listed = self._values.text(key) == "planning_pipelines"
            for item in self._values.items(value) if listed else ():
                if item is not None and (name := self._values.text(item)):
                    yield name, item

    def _loaded(self, call: ast.Call) -> dict[str, Node] | None:
        """The YAML that a function of the launch file reads from a path, or a path in a package."""
        texts = [self._values.text(one) for one in call.args]
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

"""The files that ``MoveItConfigsBuilder`` reads.

Source: ``moveit_configs_builder.py`` of moveit/moveit2, moveit_configs_utils.
"""

import ast
import os

from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UnreadableFile
from urdfkit.ros.launch.collect import UNKNOWN, Collector
from urdfkit.ros.launch.values import Values, argument, called
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.located_yaml import Key, load, mapping

#: Methods whose first argument is a file of the package.
_FILES = (
    "joint_limits", "moveit_cpp", "pilz_cartesian_limits", "robot_description",
    "robot_description_kinematics", "robot_description_semantic", "trajectory_execution",
)  # fmt: skip
#: Pipelines for which moveit_configs_utils has settings.
_PIPELINES = ("chomp", "ompl", "pilz_industrial_motion_planner", "stomp")


def use(call: ast.Call, values: Values, collector: Collector) -> None:
    """Record the files that a method of the builder reads, and its package."""
    builder = _builder(call)
    if builder is None:
        return
    robot = values.text(argument(builder, 0, "robot_name"))
    written = argument(builder, 1, "package_name")
    package = values.text(written) if written else robot and f"{robot}_moveit_config"
    if not package:
        return
    directory = collector.package(package, values.source, values.span(written or builder))
    if called(call) in _FILES:
        node = argument(call, 0, "file_path")
        path = values.text(node)
        if node is not None and path and not path.startswith(UNKNOWN):
            path = os.path.normpath(os.path.join(directory or f"{UNKNOWN}/{package}", path))
            collector.file(path, values.span(node), "MoveIt configuration")
    elif called(call) == "to_moveit_configs" and directory:
        _without_plugin(directory, collector)
    elif called(call) == "planning_pipelines" and directory:
        _default(call, values, collector)
        for item in values.items(argument(call, 1, "pipelines")):
            name = values.text(item)
            file = os.path.join(directory, "config", f"{name}_planning.yaml")
            if item is not None and name and name not in _PIPELINES and not disk.exists(file):
                message = f"planning pipeline '{name}' has no config/{name}_planning.yaml"
                message += did_you_mean(name, _PIPELINES)
                help = "add the file, or name one of " + ", ".join(_PIPELINES)
                collector.problems.append(Problem("LAU003", values.span(item), message, help))


def _default(call: ast.Call, values: Values, collector: Collector) -> None:
    """Report a default that is not one of the pipelines, which the builder rejects."""
    node = argument(call, 0, "default_planning_pipeline")
    names = [values.text(item) for item in values.items(argument(call, 1, "pipelines"))]
    known = [name for name in names if name]
    default = values.text(node)
    if node is not None and default and known and default not in names and None not in names:
        message = f"default_planning_pipeline '{default}' is not in pipelines: {', '.join(known)}"
        help = f"add '{default}' to pipelines"
        collector.problems.append(Problem("LAU024", values.span(node), message, help))


def _without_plugin(directory: str, collector: Collector) -> None:
    """Report pipelines of a package whose settings have no planning plugin."""
    for name in _PIPELINES:
        path = os.path.join(directory, "config", f"{name}_planning.yaml")
        try:
            root = mapping(load(collector.resolver.read(path))) if disk.is_file(path) else {}
        except UnreadableFile:
            continue
        if any(isinstance(key, Key) for key in root) and root.keys().isdisjoint(
            ("planning_plugin", "planning_plugins")
        ):
            message = f"config/{name}_planning.yaml has no planning plugin"
            help = f"add planning_plugins (planning_plugin up to Humble) with the plugin of {name}"
            if mapping(root, name):
                message += f": its settings are below '{name}'"
                help = f"remove '{name}:', and the indentation below it"
            first = next(key for key in root if isinstance(key, Key))
            problem = Problem("LAU024", first.span, message, help, severity=Severity.WARNING)
            collector.problems.append(problem)


def _builder(call: ast.Call) -> ast.Call | None:
    """The call that begins a chain of methods, if it creates a builder."""
    node: ast.expr = call
    while isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        node = node.func.value
    is_builder = isinstance(node, ast.Call) and called(node) == "MoveItConfigsBuilder"
    return node if isinstance(node, ast.Call) and is_builder and node is not call else None

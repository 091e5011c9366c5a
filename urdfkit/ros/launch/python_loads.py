"""Files of a package that a function of a launch file reads, as ``load_yaml`` of MoveIt does.

Source: ``launch_param_builder.py`` of PickNikRobotics/launch_param_builder.
"""

import ast
import os
from collections.abc import Iterator

from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.python_file import PythonLaunchFile
from urdfkit.ros.launch.values import PACKAGE_DIRECTORY

#: The parameters of such a function: a package, and a path in it.
_PACKAGE_AND_PATH = 2


def loading_functions(tree: ast.Module) -> Iterator[str]:
    """The functions that open a file, whose package and path they get."""
    for function in tree.body:
        names = (
            [one.arg for one in function.args.args] if isinstance(function, ast.FunctionDef) else []
        )
        if not isinstance(function, ast.FunctionDef) or len(names) != _PACKAGE_AND_PATH:
            continue
        calls = [node for node in ast.walk(function) if isinstance(node, ast.Call)]
        package, path = (
            any(called(call) in kinds and _last(call) == name for call in calls)
            for name, kinds in zip(names, (PACKAGE_DIRECTORY, ("join",)), strict=True)
        )
        if package and path and any(called(call) == "open" for call in calls):
            yield function.name


def _last(call: ast.Call) -> str:
    """The name that is the last argument of a call."""
    return call.args[-1].id if call.args and isinstance(call.args[-1], ast.Name) else ""


def record_loaded(file: PythonLaunchFile, call: ast.Call) -> None:
    """Record the file that such a function reads."""
    if len(call.args) == _PACKAGE_AND_PATH and not call.keywords:
        _record(file, *call.args)


def record_parameters(file: PythonLaunchFile, call: ast.Call) -> None:
    """Record the file that ``ParameterBuilder(package).yaml(path)`` reads."""
    builder: ast.expr | None = call
    while isinstance(builder, ast.Call) and isinstance(builder.func, ast.Attribute):
        builder = file.values.resolved(builder.func.value)
    path = argument(call, 0, "file_path")
    if isinstance(builder, ast.Call) and called(builder) == "ParameterBuilder" and path:
        package = argument(builder, 0, "package_name")
        if package is not None:
            _record(file, package, path)


def _record(file: PythonLaunchFile, package: ast.expr, path: ast.expr) -> None:
    """Record a file of a package that is read when the launch file runs."""
    name, inside = file.values.text(package), file.values.text(path)
    if name and inside and not os.path.isabs(inside):
        directory = file.collector.package(name, file.source, file.values.span(package))
        if directory is not None:
            whole = os.path.join(directory, inside)
            file.collector.file(whole, file.values.span(path), "file")

"""Files that a function of a launch file reads from a package, as ``load_yaml`` of MoveIt does."""

import ast
import os
from collections.abc import Iterator

from urdfkit.ros.launch.python_file import PythonLaunchFile
from urdfkit.ros.launch.values import PACKAGE_DIRECTORY, called

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
    texts = [file.values.text(argument) for argument in call.args]
    if len(texts) != _PACKAGE_AND_PATH or call.keywords:
        return
    package, path = texts
    if package and path and not os.path.isabs(path):
        place = file.values.span(call.args[0])
        directory = file.collector.package(package, file.source, place)
        if directory is not None:
            span = file.values.span(call.args[1])
            file.collector.file(os.path.join(directory, path), span, "file")

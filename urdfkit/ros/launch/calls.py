"""The name, the arguments and the joined parts of a call in a Python launch file."""

import ast

from urdfkit.text.python_source import dotted_name


def called(node: ast.AST | None) -> str:
    """The name of the function or method that an expression calls; empty for another one."""
    function = node.func if isinstance(node, ast.Call) else None
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def argument(call: ast.Call, position: int | None, name: str) -> ast.expr | None:
    """An argument of a call, by name or position."""
    for keyword in call.keywords:
        if keyword.arg == name:
            return keyword.value
    if position is not None and position < len(call.args):
        return call.args[position]
    return None


def parts_of_path(call: ast.Call) -> list[ast.expr]:
    """The parts that a call joins to a path; empty for other calls.

    ``join`` of a text, as in ``os.pathsep.join([...])``, takes one argument.
    """
    name, function, parts = called(call), call.func, call.args
    if name == "PathJoinSubstitution":
        return parts[0].elts if parts and isinstance(parts[0], (ast.List, ast.Tuple)) else []
    if name == "joinpath" and isinstance(function, ast.Attribute):
        return [function.value, *parts]
    if name == "Path":
        return parts if len(parts) > 1 else []
    is_path = name == "join" and (len(parts) > 1 or dotted_name(function) == "os.path.join")
    return parts if is_path else []

"""What the functions of a Python launch file return, such as the path of a file in a package."""

import ast

from urdfkit.core.grouping import by_key
from urdfkit.ros.launch.bound_parameters import bound_parameters
from urdfkit.text.python_source import nodes, own_nodes


def returned_values(tree: ast.Module) -> dict[ast.Call, ast.expr]:
    """The expressions that functions with one ``return`` return, by their calls."""
    functions = {bound.call: node for node, bound in bound_parameters(tree).items()}
    defined = by_key((node.name, node) for node in nodes(tree) if isinstance(node, ast.FunctionDef))
    for call in nodes(tree):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name):
            named = defined.get(call.func.id, [])
            if len(named) == 1 and not (call.args or call.keywords or _takes_arguments(named[0])):
                functions.setdefault(call, named[0])
    values = {call: returned_value(node) for call, node in functions.items()}
    return {call: value for call, value in values.items() if value is not None}


def returned_value(function: ast.FunctionDef) -> ast.expr | None:
    """What a function returns if its last statement is its only ``return``."""
    last = function.body[-1]
    returns = sum(isinstance(node, (ast.Return, ast.Yield)) for node in own_nodes(function))
    return last.value if isinstance(last, ast.Return) and returns == 1 else None


def _takes_arguments(function: ast.FunctionDef) -> bool:
    return any(isinstance(node, ast.arg) for node in ast.walk(function.args))

"""Functions of a Python launch file that create actions and are called several times.

They get one copy for each call, so that their parameters have one value each.
"""

import ast
from collections import Counter
from copy import deepcopy
from functools import lru_cache

from urdfkit.core.grouping import by_key
from urdfkit.ros.launch.calls import called
from urdfkit.ros.launch.returned_values import returned_value
from urdfkit.text.python_source import nodes

_ACTIONS = frozenset(
    ("ComposableNode", "ExecuteProcess", "IncludeLaunchDescription", "LifecycleNode", "Node")
)
#: Most calls of one function, of one that only returns a value, and most nodes of the syntax tree
#: that all copies of a file may have: copies take time and memory.
_MAX_CALLS, _MAX_VALUES, MAX_NODES = 12, 40, 20_000


@lru_cache(maxsize=4)  # a file is read once for each set of its arguments
def with_copies(tree: ast.Module) -> ast.Module:
    """The tree with a copy of such a function for each call; the same tree if there is none."""
    functions = _repeated(tree)
    sizes = (len(tuple(ast.walk(node))) * (count - 1) for node, count in functions.items())
    if not functions or sum(sizes) > MAX_NODES:
        return tree
    counts = {node.name: count for node, count in functions.items()}
    try:
        copied = deepcopy(tree)
    except RecursionError:
        return tree
    owners: list[ast.Module | ast.FunctionDef] = [copied]
    owners += [node for node in ast.walk(copied) if isinstance(node, ast.FunctionDef)]
    for owner in owners:
        owner.body = [copy for node in owner.body for copy in (node, *_copies(node, counts))]
    return copied


def _copies(node: ast.stmt, counts: dict[str, int]) -> list[ast.stmt]:
    """The further copies of a function."""
    count = counts.get(node.name, 1) if isinstance(node, ast.FunctionDef) else 1
    return [deepcopy(node) for _ in range(count - 1)]


def _repeated(tree: ast.Module) -> dict[ast.FunctionDef, int]:
    """Functions that are called several times, and used in no other way, with their calls."""
    defined = by_key((node.name, node) for node in nodes(tree) if isinstance(node, ast.FunctionDef))
    names = [node for node in nodes(tree) if isinstance(node, ast.Name)]
    uses = Counter(node.id for node in names)
    calls = Counter(called(node) for node in nodes(tree) if isinstance(node, ast.Call))
    found = {
        functions[0]: uses[name]
        for name, functions in defined.items()
        if len(functions) == 1
        and uses[name] == calls[name]
        and (functions[0].args.args or functions[0].args.vararg)
        and 1 < uses[name] <= _most_calls(functions[0])
    }
    # What others call is copied after them: each copy of the others calls it.
    inner = {called(node) for function in found for node in ast.walk(function)}
    return {function: count for function, count in found.items() if function.name not in inner}


def _most_calls(function: ast.FunctionDef) -> int:
    if creates_actions(function):
        return _MAX_CALLS
    return _MAX_VALUES if returned_value(function) is not None else 0


def creates_actions(node: ast.AST) -> bool:
    """True for a part of a program that creates actions of launch."""
    return any(isinstance(one, ast.Call) and called(one) in _ACTIONS for one in ast.walk(node))

"""Arguments that a Python launch file declares after an action that uses them."""

import ast
import os
from collections.abc import Iterator

from urdfkit.ros.catalog import data
from urdfkit.ros.launch.argument_checks import is_included
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.collect import UNKNOWN, path_from
from urdfkit.ros.launch.signature import declares, signature
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem

#: Actions whose arguments launch asks for when it comes to them.
_IMMEDIATE = (
    "ComposableNodeContainer", "DeclareLaunchArgument", "ExecuteProcess",
    "IncludeLaunchDescription", "LifecycleNode", "LoadComposableNodes", "Node",
)  # fmt: skip
#: Actions that declare nothing.
_PLAIN = (
    *_IMMEDIATE, "AppendEnvironmentVariable", "LogInfo", "RegisterEventHandler",
    "SetEnvironmentVariable", "SetParameter", "TimerAction",
)  # fmt: skip


def declared_late(calls: list[ast.Call], values: Values) -> Iterator[Problem]:
    """Uses of arguments before their declaration, at which launch stops.

    A file that others include is not reported: they may set the arguments.
    """
    actions = _actions(calls, values)
    names = [_declared(action, values) for action in actions]
    known: set[str] = set()
    uses: dict[str, ast.Call] = {}
    for position, action in enumerate(actions):
        if action is None:
            break
        later = {name for name in names[position + 1 :] if name}
        for name, call in _used(action, values) if called(action) in _IMMEDIATE else ():
            if name in later - known:
                uses.setdefault(name, call)
        known.add(names[position])
        if called(action) == "IncludeLaunchDescription":
            taken = _included(action, values)
            if taken is None:
                break
            known |= taken
        elif called(action) not in _PLAIN and not names[position]:
            break
    if uses and not is_included(values.source.path, values.collector.resolver):
        for name, call in uses.items():
            message = f"argument '{name}' is used before it is declared"
            help = "move its DeclareLaunchArgument above the action"
            yield Problem("LAU006", values.span(call), message, help)


def _actions(calls: list[ast.Call], values: Values) -> list[ast.Call | None]:
    """The actions of the only launch description, in order; None for unknown ones."""
    descriptions = [call for call in calls if called(call) == "LaunchDescription"]
    if len(descriptions) != 1:
        return []
    written = argument(descriptions[0], 0, "initial_entities")
    items = values.items(written) if written is not None else []
    added = [call for call in calls if called(call) == "add_action"]
    added.sort(key=lambda call: (call.lineno, call.col_offset))
    nodes = [values.resolved(item) for item in (*items, *(argument(c, 0, "action") for c in added))]
    return [node if isinstance(node, ast.Call) else None for node in nodes]


def _declared(action: ast.Call | None, values: Values) -> str:
    if action is None or not declares(action):
        return ""
    return values.text(argument(action, 0, "name")) or ""


def _used(action: ast.Call, values: Values) -> Iterator[tuple[str, ast.Call]]:
    """The arguments that an action asks for, or its condition if it has one."""
    stack: list[ast.AST | None] = [argument(action, None, "condition") or action]
    seen: set[ast.AST] = set()
    while stack:
        node = stack.pop()
        node = values.resolved(node) if isinstance(node, ast.Name) else node
        if node is None or node in seen or isinstance(node, ast.Lambda):
            continue
        seen.add(node)
        if isinstance(node, ast.Call) and called(node) == "LaunchConfiguration":
            name = values.text(argument(node, 0, "variable_name"))
            if name and argument(node, 1, "default") is None:
                yield name, node
            continue
        stack += ast.iter_child_nodes(node)


def _included(action: ast.Call, values: Values) -> set[str] | None:
    """The arguments that are set after an include; None if unknown."""
    text = values.text(argument(action, 0, "launch_description_source"))
    path = path_from(values.source, text) if text else ""
    names = _declared_in(path, values)
    if not names or argument(action, None, "condition") is not None:
        return None
    node = values.resolved(argument(action, 1, "launch_arguments"))
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        node = values.resolved(node.func.value)
    pairs = values.pairs(node) if isinstance(node, ast.expr) else []
    return names.union(values.text(key) or "" for key, _ in pairs)


def _declared_in(path: str, values: Values) -> set[str]:
    """The arguments of a launch file, of the workspace or of ROS; empty if not all are known."""
    source = values.collector.resolver.readable(path) if path else None
    if source is not None:
        taken = signature(source)
        return set(taken.names) if taken.is_whole else set()
    package = path.removeprefix(f"{UNKNOWN}/").partition("/")[0]
    files: dict[str, str] = data("launch")["launch_files"].get(package, {})
    return set(files.get(os.path.basename(path), "").split())

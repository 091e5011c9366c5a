"""The launch description that a Python launch file returns, and its actions."""

import ast
import re
from collections.abc import Collection, Iterator

from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.ros.launch.calls import called
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.python_source import own_nodes
from urdfkit.text.source import Source, Span

#: The function that launch calls.
_ENTRY = "generate_launch_description"
#: Actions without effect unless they are in a launch description.
ACTIONS = ("ExecuteProcess", "IncludeLaunchDescription", "Node")
_GROUP = "GroupAction"
#: Arguments with a list of actions, with their places, by action.
HOLDERS = {
    _GROUP: (0, "actions"),
    "LaunchDescription": (0, "initial_entities"),
    "TimerAction": (None, "actions"),
}
#: Bytes before an action in which the name is looked for that it is assigned to.
_LONGEST_TARGET = 200
#: Actions that start other actions later.
TRIGGERS = ("RegisterEventHandler", "TimerAction")


def entry_point(tree: ast.Module, source: Source) -> Iterator[Problem]:
    """The problem if the function that launch calls is missing or returns nothing."""
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    entries = [function for function in functions if function.name == _ENTRY]
    if entries and not _returns_value(entries[-1]):
        span = _name_of(entries[-1], source)
        message, help = f"{_ENTRY}() returns nothing", "return the LaunchDescription"
        yield Problem("LAU033", span, message, help, severity=Severity.ERROR)
    by_name = {function.name: function for function in functions}
    if _ENTRY.encode() not in source.data and (name := nearest(_ENTRY, by_name, CLOSE_TYPO)):
        span = _name_of(by_name[name], source)
        message, help = f"launch calls {_ENTRY}(), which is missing", f"write def {_ENTRY}()"
        yield Problem("LAU033", span, message, help, severity=Severity.ERROR)


def _name_of(function: ast.FunctionDef, source: Source) -> Span:
    """The name in the definition of a function."""
    start = source.offset(function.lineno, 1) + function.col_offset
    match = re.compile(rb"def\s+([^\s(]+)").match(source.data, start)
    return Span(source, *match.span(1)) if match else Span(source, start, start)


def _returns_value(function: ast.FunctionDef) -> bool:
    """True if a function returns a value, or does not return."""
    return any(
        isinstance(node, (ast.Raise, ast.Yield, ast.YieldFrom))
        or (isinstance(node, ast.Return) and node.value is not None)
        for node in own_nodes(function)
    )


def not_started(calls: Collection[ast.expr], values: Values) -> Iterator[Problem]:
    """Actions that are assigned to an unused name, without those that only others of them use."""
    inner = {name.id for call in calls for name in ast.walk(call) if isinstance(name, ast.Name)}
    for call in calls:
        action = called(values.created(call))
        if action not in (*ACTIONS, *TRIGGERS, _GROUP):
            continue
        before = values.source.data[: values.span(call).start]
        assigned = re.search(rb"(\w+)\s*=[\s\\(]*$", before[-_LONGEST_TARGET:])
        name = assigned[1].decode() if assigned else ""
        if not name or name in inner:
            continue
        message = f"'{name}' is created but never started"
        help = f"add {name} to the LaunchDescription, or remove it"
        is_meant = re.search(rb"(?m)^[^#\n]*#.*\b%b\b" % name.encode(), values.source.data)
        severity = Severity.INFO if is_meant or action in TRIGGERS else Severity.WARNING
        yield values.problem("LAU037", call, message, help, severity)

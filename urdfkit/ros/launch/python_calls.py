"""Calls of classes of launch with arguments that they do not have, or in the wrong place."""

import ast
from collections.abc import Iterator

from urdfkit.core.suggest import is_typo, nearest
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.components import wrong_component, wrong_container
from urdfkit.ros.launch.launch_description import HOLDERS
from urdfkit.ros.launch.python_names import modules_with
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.python_source import dotted_name, nodes, own_nodes, string

#: Arguments with a list of actions, by class or method.
_HOLDERS = {**HOLDERS, "add_action": (0, "action"), "add_entity": (0, "entity")}
#: The action that takes what is no action itself, by the modules of launch with such classes.
_TAKEN_BY = {
    "launch.event_handlers": "RegisterEventHandler",
    "launch_ros.event_handlers": "RegisterEventHandler",
    "launch.launch_description_sources": "IncludeLaunchDescription",
}
#: What functions return in place of a list of actions.
_RETURNED = (
    "ExecuteProcess", "GroupAction", "IncludeLaunchDescription", "LaunchDescription", "Node",
)  # fmt: skip
#: The executables of containers begin with this, and what gives a container its name.
_CONTAINER, _NAMES = "component_container", ("namespace", "name")
#: Modules of launch with conditions and with substitutions.
_KINDS = ("conditions", "substitutions")
#: What to write in place of conditions.
_SUBSTITUTES = {
    "LaunchConfigurationEquals": "write EqualsSubstitution(LaunchConfiguration(...), ...)",
    "LaunchConfigurationNotEquals": "write NotEqualsSubstitution(LaunchConfiguration(...), ...)",
    "UnlessCondition": "write NotSubstitution(...)",
}
#: Arguments of Foxy and before, which are reported as such.
_FORMER = ("node_", "package_")
#: What a LaunchConfiguration becomes when a launch file runs.
_UNKNOWN = "LaunchConfiguration"
#: Comparisons of a value with another one, or with those of a list.
_COMPARING = (ast.Eq, ast.NotEq, ast.In, ast.NotIn)


def wrong_calls(tree: ast.Module, calls: list[ast.Call], values: Values) -> Iterator[Problem]:
    """Problems of calls of classes that are imported from launch or launch_ros."""
    imported = _imported(tree)
    for call in calls:
        if _is_of_launch(call, imported):
            yield from _keywords(call, values)
            yield from _missing(call, values)
            yield from _positional(call, values)
            yield from _output(call, values)
            yield from _conditions(call, values)
            yield from _component(call, values)
        yield from _no_actions(call, values)
        yield from _without_effect(call, values)
        yield from _no_list(call, tree, values)
        yield from _evaluated(call, values)
    yield from _compared(tree, values)
    yield from _wrong_targets(calls, values)


def _wrong_targets(calls: list[ast.Call], values: Values) -> Iterator[Problem]:
    """Composable nodes for a container that has another name; none with pushed namespaces."""
    names = [called(call) for call in calls]
    if "LoadComposableNodes" not in names or any(name.startswith("PushR") for name in names):
        return
    started = [
        call
        for call in calls
        if called(call) == "ComposableNodeContainer"
        or (values.text(argument(call, None, "executable")) or "").startswith(_CONTAINER)
    ]
    parts = [
        [_text_or_none(argument(call, None, key), values) for key in _NAMES] for call in started
    ]
    containers = ["/".join(filter(None, pair)) for pair in parts if None not in pair]
    for call in calls if len(containers) == len(started) else ():
        node = argument(call, None, "target_container")
        text = values.text(node) if called(call) == "LoadComposableNodes" else None
        if node is not None and text and (wrong := wrong_container(text, containers)):
            yield values.problem("LAU038", node, *wrong)


def _text_or_none(node: ast.expr | None, values: Values) -> str | None:
    """The text of an argument, which is empty if it is not given; None if it is unknown."""
    return "" if node is None else values.text(node)


def _imported(tree: ast.Module) -> set[str]:
    """The names that a file imports from launch or launch_ros."""
    return {
        alias.asname or alias.name
        for node in nodes(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("launch")
        for alias in node.names
    }


def _is_of_launch(call: ast.Call, imported: set[str]) -> bool:
    if isinstance(call.func, ast.Name):
        return call.func.id in imported
    first = dotted_name(call.func).partition(".")[0]
    return first in ("launch", "launch_ros") or first in imported


def _keywords(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Arguments that a class does not have: Python stops at them."""
    name = called(call)
    known = data("launch_python")["keywords"].get(name, "").split()
    for keyword in call.keywords if known else ():
        given = keyword.arg or ""
        if given and given not in known and not given.startswith(_FORMER):
            former = data("launch_python")["of_roslaunch"].get(given, "")
            match = former if former.partition("=")[0] in known else nearest(given, known)
            help = f"write {match}" if match else f"{name} has {', '.join(sorted(known))}"
            every = data("launch_python")["keywords"].items()
            owner = next((other for other, names in every if given in names.split()), "")
            if owner and not (match and (given in match or is_typo(given, match))):
                help = f"remove it: it is an argument of {owner}"
            message = f"{name} has no argument '{given}'"
            yield values.problem("LAU033", keyword.value, message, help)


def _missing(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Arguments that a class must have: Python stops without them."""
    required = data("launch_python")["required"].get(called(call), "").split()
    given = {keyword.arg or "" for keyword in call.keywords}
    known = data("launch_python")["keywords"].get(called(call), "").split()
    if _is_open(call) or (known and given.difference(known)):
        return  # one of them may be misspelt
    missing = [name for name in required[len(call.args) :] if name not in given]
    if missing:
        message = f"{called(call)} has no {' and no '.join(missing)}"
        help = "write " + ", ".join(f"{name}=..." for name in missing)
        yield values.problem("LAU033", call.func, message, help)


def _positional(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Positional arguments that a class does not take: Python stops at them."""
    facts, name = data("launch_python"), called(call)
    most = next((int(n) for n, names in facts["positional"].items() if name in names.split()), None)
    if most is None or len(call.args) <= most or _is_open(call):
        return
    given = {keyword.arg for keyword in call.keywords}
    known = facts["required"].get(name, "").split()[most:] or facts["keywords"][name].split()[most:]
    names = [f"{other}=..." for other in known if other not in given and other != "condition"]
    message = f"{name} takes {most} positional argument{'s' * (most != 1)}, "
    message += f"and {len(call.args)} {'is' if len(call.args) == 1 else 'are'} given"
    takes_list = name in facts["lists"].split() or not names
    help = "write them in [ ]" if takes_list else f"write {', '.join(names)}"
    yield values.problem("LAU033", call.args[most], message, help)


def _is_open(call: ast.Call) -> bool:
    """True if values are given that are not written there."""
    return any(isinstance(value, ast.Starred) for value in call.args) or any(
        keyword.arg is None for keyword in call.keywords
    )


def _no_list(call: ast.Call, tree: ast.Module, values: Values) -> Iterator[Problem]:
    """A function of an OpaqueFunction that returns an action instead of a list of actions."""
    if called(call) != "OpaqueFunction":
        return
    function = argument(call, 0, "function")
    name = function.id if isinstance(function, ast.Name) else ""
    for node in tree.body:
        if not isinstance(node, ast.FunctionDef) or node.name != name:
            continue
        for inner in own_nodes(node):
            returned = inner.value if isinstance(inner, ast.Return) else None
            kind = called(values.resolved(returned)) if returned else ""
            if returned and kind in _RETURNED:
                message = f"{name}() returns a {kind}, but launch expects a list of actions"
                yield values.problem("LAU033", returned, message, "write it in [ ]")


def _output(call: ast.Call, values: Values) -> Iterator[Problem]:
    node = argument(call, None, "output")
    known = data("launch_python")["outputs"].split()
    text = string(values.resolved(node))
    if node is not None and text is not None and text not in known:
        message = f"output is '{text}', which launch does not know"
        yield values.problem("LAU033", node, message, f"write {' or '.join(known)}")


def _conditions(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Substitutions in place of conditions, and the reverse: launch stops at both."""
    modules = data("launch_python")["modules"]
    conditions, substitutions = (modules[f"launch.{kind}"].split() for kind in _KINDS)
    node = argument(call, None, "condition")
    name = called(values.resolved(node))
    takes_substitutions = called(call) in substitutions  # IfElseSubstitution has a condition, too
    if node is not None and name in substitutions and not takes_substitutions:
        message = f"{name} is no condition, but a substitution"
        yield values.problem("LAU033", node, message, f"write IfCondition({name}(...))")
    if called(call) not in conditions and not takes_substitutions:
        return
    for item in [*call.args, *([node] if node is not None and takes_substitutions else [])]:
        inner = called(values.resolved(item))
        if inner in conditions:
            message = f"{called(call)} takes a substitution, but {inner} is a condition"
            help = _SUBSTITUTES.get(inner, "write what the condition asks")
            yield values.problem("LAU033", item, message, help)


def _component(call: ast.Call, values: Values) -> Iterator[Problem]:
    node = argument(call, None, "plugin")
    if node is None or called(call) != "ComposableNode":
        return
    package = values.text(argument(call, None, "package"))
    if wrong := wrong_component(package, values.text(node)):
        yield values.problem("LAU038", node, *wrong)


def _no_actions(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Event handlers and other objects among the actions, at which launch stops."""
    if called(call) not in _HOLDERS:
        return
    node = argument(call, *_HOLDERS[called(call)])
    value = values.resolved(node)
    items = [node] if isinstance(value, ast.Call) else values.items(node) if node else []
    for item in items:
        name = called(values.resolved(item))
        if item is not None and (action := _taken_by(name)):
            message, help = f"{name} is not an action", f"write {action}({name}(...))"
            yield values.problem("LAU033", item, message, help)


def _taken_by(name: str) -> str:
    """The action that takes an object of a class; empty for an action, and for another class."""
    if name == "ComposableNode":
        return "ComposableNodeContainer"
    return next((_TAKEN_BY[one] for one in modules_with(name) if one in _TAKEN_BY), "")


def _without_effect(call: ast.Call, values: Values) -> Iterator[Problem]:
    """An action that applies to the nodes after it, behind the last node."""
    facts = data("launch_python")
    scopes, actions = facts["scopes"].split(), facts["actions"].split()
    if called(call) not in ("GroupAction", "LaunchDescription"):
        return
    items = values.items(argument(call, *_HOLDERS[called(call)]))
    if not items or called(values.resolved(items[-1])) not in scopes:
        return
    names: list[tuple[ast.expr, str]] = []
    for item in items:
        action = values.resolved(item)
        if item is None or not isinstance(action, ast.Call):
            return
        names.append((item, called(action)))
    while names and names[-1][1] in scopes:
        item, name = names.pop()
        if any(before in actions for _, before in names):
            message = f"{name} has no effect: it applies to the actions after it"
            yield values.problem(
                "LAU037", item, message, "move it above the nodes", Severity.WARNING
            )


def _compared(tree: ast.Module, values: Values) -> Iterator[Problem]:
    """Conditions of Python on a LaunchConfiguration, which is not its value."""
    for node in nodes(tree):
        if isinstance(node, ast.Compare) and isinstance(node.ops[0], _COMPARING):
            for side in (node.left, *node.comparators):
                if _is_configuration(side, values):
                    message = f"{_UNKNOWN} is compared before it has a value"
                    help = "compare its .perform(context) in an OpaqueFunction, or write "
                    help += "EqualsSubstitution(configuration, text)"
                    yield values.problem("LAU034", node, message, help, Severity.WARNING)
        elif isinstance(node, (ast.If, ast.IfExp)):
            test = node.test
            if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
                test = test.operand
            if _is_configuration(test, values):
                message = f"a {_UNKNOWN} is always true in Python: it has no value yet"
                help = "pass condition=IfCondition(...), or ask its .perform(context) in an "
                yield values.problem(
                    "LAU034", test, message, f"{help}OpaqueFunction", Severity.WARNING
                )
            elif text := _performed(test, values):
                message = f"the text '{text}' is true in Python, and 'false' is, too"
                yield values.problem(
                    "LAU034", test, message, "compare its .lower() with 'true'", Severity.WARNING
                )


def _performed(node: ast.expr, values: Values) -> str:
    """The text of a boolean argument whose text Python takes for its value."""
    call = values.resolved(node)
    if not isinstance(call, ast.Call) or not isinstance(call.func, ast.Attribute):
        return ""
    owner = call.func.value
    is_text = call.func.attr == "perform" and _is_configuration(owner, values)
    text = values.text(owner) or "" if is_text else ""
    return text if text.lower() in ("true", "false") else ""


def _evaluated(call: ast.Call, values: Values) -> Iterator[Problem]:
    """The text of a boolean argument in an expression of Python, which has no ``true``."""
    if called(call) != "PythonExpression":
        return
    quote, is_known = "", True  # the open one, and whether it is known
    for item in values.items(argument(call, 0, "expression")):
        text = values.text(item)
        is_name = text in ("true", "false") and is_known and not quote
        if item is not None and is_name and _is_configuration(item, values):
            message = f"the expression contains {text}, which is no name of Python"
            help = "write it in quotes, and compare: \"'\", ..., \"' == 'true'\""
            yield values.problem("LAU034", item, message, help)
        quote, is_known = _open_quote(quote, text or ""), text is not None


def _open_quote(quote: str, text: str) -> str:
    """The quote that is open behind a text; empty if none is."""
    for character in text:
        if character in "'\"" and quote in ("", character):
            quote = "" if quote else character
    return quote


def _is_configuration(node: ast.expr, values: Values) -> bool:
    return called(values.resolved(node)) == _UNKNOWN

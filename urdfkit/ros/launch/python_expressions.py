"""Expressions of a Python launch file with another value than the written one, or none.

launch concatenates the texts and substitutions of a list when it runs; until then a substitution is
an object without a text.
"""

import ast
from collections.abc import Collection, Iterable, Iterator
from itertools import pairwise

from urdfkit.ros.launch.calls import called, parts_of_path
from urdfkit.ros.launch.values import PACKAGE_DIRECTORY, Values
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.python_source import dotted_name, string

#: Substitutions, whose text is known only at run time.
_SUBSTITUTIONS = ("Command", "FindPackageShare", "LaunchConfiguration", "PathJoinSubstitution")
#: Functions that expect a text, with what to write instead.
_AT_RUN_TIME = "pass its .perform(context) in an OpaqueFunction"
_OF_TEXTS = {
    "float": _AT_RUN_TIME,
    "get_package_share_directory": "write FindPackageShare(...) in a PathJoinSubstitution",
    "get_package_share_path": "write FindPackageShare(...) in a PathJoinSubstitution",
    "int": _AT_RUN_TIME,
    "open": _AT_RUN_TIME,
    "os.path.exists": _AT_RUN_TIME,
    "os.path.isfile": _AT_RUN_TIME,
    "os.path.join": "write PathJoinSubstitution([...]) with the same parts",
    "xacro.process_file": 'write Command(["xacro ", ...])',
}
#: Home directories, whose paths are absolute on purpose.
_HOMES = ("/home/", "/root/", "/Users/")
#: Functions that show a text to the user alone.
_SHOWING = ("print", "debug", "info", "warn", "warning", "error")


def wrong_expressions(expressions: Iterable[ast.expr], values: Values) -> Iterator[Problem]:
    """Paths and texts that Python joins otherwise, or rejects."""
    expressions = list(expressions)
    calls = (node for node in expressions if isinstance(node, ast.Call))
    shown = {text for call in calls if called(call) in _SHOWING for text in call.args}
    for node in expressions:
        if isinstance(node, ast.Call):
            problem = _dropped_directory(node, values) or _joined(node, values)
        else:
            problem = _added(node, values)
            problem = problem or (None if node in shown else _formatted(node, values))
        if problem:
            yield problem


def _dropped_directory(call: ast.Call, values: Values) -> Problem | None:
    """A part of a path that begins with a slash: the parts before it are dropped."""
    for part in parts_of_path(call)[1:]:
        text = string(part) or ""
        if text.startswith("/") and not text.startswith(_HOMES):
            message = f"'{text}' begins with a slash, so the directories before it are dropped"
            help = f"write '{text.lstrip('/')}'"
            return Problem("LAU003", values.span(part), message, help, severity=Severity.ERROR)
    return None


def _joined(call: ast.Call, values: Values) -> Problem | None:
    """A substitution in a function of Python that expects a text: its value is unknown."""
    function = dotted_name(call.func)
    if function not in _OF_TEXTS:
        return None
    for part in call.args if function == "os.path.join" else call.args[:1]:
        name = called(values.resolved(part))
        if name in _SUBSTITUTIONS:
            message = f"{function} rejects {name}: its value is known only at run time"
            return values.problem("LAU034", part, message, _OF_TEXTS[function])
    return None


def _added(node: ast.expr, values: Values) -> Problem | None:
    """A text and a substitution with a plus between them, which Python rejects."""
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.Add):
        return None
    sides = [values.resolved(side) for side in (node.left, node.right)]
    has_text = any(string(side) is not None for side in sides)
    substitution = next((name for name in map(called, sides) if name in _SUBSTITUTIONS), "")
    if not (substitution and has_text):
        return None
    message = f"a string and a {substitution} cannot be added: its value is known only at run time"
    return values.problem(
        "LAU034", node, message, "write both into a list, with a comma between them"
    )


def _formatted(node: ast.expr, values: Values) -> Problem | None:
    """A substitution in an f-string, which has the name of its class and not its value."""
    for part in node.values if isinstance(node, ast.JoinedStr) else ():
        value = values.resolved(part.value) if isinstance(part, ast.FormattedValue) else None
        if called(value) in _SUBSTITUTIONS:
            message = (
                f"an f-string does not have the value of {called(value)}, which is known only "
            )
            message += "at run time"
            help = "write a list: [text, substitution]"
            if isinstance(part, ast.FormattedValue) and values.has_context(part.value):
                help = f"write {{{ast.unparse(part.value)}.perform(context)}}"
            return values.problem("LAU034", node, message, help)
    return None


def missing_slash(pieces: Collection[ast.expr | None], values: Values) -> Iterator[Problem]:
    """A path after the directory of a package without a slash, which launch does not add."""
    for before, piece in pairwise(pieces):
        directory = values.resolved(before)
        text = string(piece) or ""
        is_package = called(directory) in PACKAGE_DIRECTORY
        if piece is not None and is_package and text[:1].isalpha():
            message = f"'{text}' follows the directory of a package without a slash"
            yield values.problem("LAU003", piece, message, f"write '/{text}'")

"""Calls of a Python launch file that launch rejects, or that have no effect."""

import ast
import re
from collections.abc import Collection, Iterator
from itertools import pairwise

from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.values import PACKAGE_DIRECTORY, Values, argument, called, parts_of_path
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.python_source import string
from urdfkit.text.source import Source, Span

#: The function that launch calls.
_ENTRY = "generate_launch_description"

#: Actions without effect unless they are in a launch description.
ACTIONS = ("ExecuteProcess", "IncludeLaunchDescription", "Node")
#: Actions that start other actions later.
TRIGGERS = ("RegisterEventHandler", "TimerAction")
#: Arguments of a call that must be lists, with their expected type.
_LISTS = {"arguments": "a list of words", "parameters": "a list", "remappings": "a list of pairs"}
#: Arguments with a list of actions, by action.
_HOLDERS = {
    "GroupAction": (0, "actions"),
    "LaunchDescription": (0, "initial_entities"),
    "TimerAction": (None, "actions"),
}
_CONDITIONS = ("IfCondition", "UnlessCondition")
#: Suffixes of the files that each source of a launch description reads.
_SOURCES = {
    "PythonLaunchDescriptionSource": (".py",),
    "XMLLaunchDescriptionSource": (".xml", ".launch"),
    "YAMLLaunchDescriptionSource": (".yaml", ".yml"),
}
#: Names of Node's arguments until Foxy.
_FORMER = {"node_executable": "executable", "node_name": "name", "node_namespace": "namespace"}
#: Substitutions, whose text is known only at run time.
_SUBSTITUTIONS = ("Command", "FindPackageShare", "LaunchConfiguration", "PathJoinSubstitution")
#: Functions of xacro that return a document, whose text is required.
_DOCUMENTS = ("process_file", "parse")
_TEXTS = ("toxml", "toprettyxml")
#: An option and its value on one line, without a comma.
_JOINED = re.compile(r"""(["'])-[\w-]+\1[ \t]*["']""")
_BOOLEAN = re.compile(r"(?i)\s*(true|false|1|0)\s*")
#: Numbers and booleans, as launch accepts only texts and substitutions.
_SCALARS = (bool, int, float)


def mistakes(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Arguments with a type that launch rejects when it creates an action."""
    name = called(call)
    if name == "Node":
        yield from _lists(call, values)
        yield from _words(argument(call, None, "arguments"), values)
        yield from _documents(argument(call, None, "parameters"), values)
        yield from _sets(argument(call, None, "parameters"), values)
        yield from _without_package(call, values)
        yield from _former(call, values)
    elif name in _HOLDERS:
        yield from _action_list(call, values)
    elif name in _SOURCES:
        yield from _source(call, values)
    elif name == "ExecuteProcess":
        yield from _process(call, values)
    elif name == "DeclareLaunchArgument":
        yield from _text(argument(call, 1, "default_value"), "default_value", values)
    elif name == "IncludeLaunchDescription":
        yield from _passed(argument(call, 1, "launch_arguments"), values)
    elif name in _CONDITIONS:
        yield from _condition(argument(call, 0, "predicate_expression"), values)


def not_started(calls: Collection[ast.expr], values: Values) -> Iterator[Problem]:
    """Actions that are assigned to an unused name, without those that only others of them use."""
    inner = {name.id for call in calls for name in ast.walk(call) if isinstance(name, ast.Name)}
    for call in calls:
        if not isinstance(call, ast.Call) or called(call) not in (*ACTIONS, *TRIGGERS):
            continue
        span = values.span(call)
        name = values.source.data[: span.start].decode("utf-8", "replace").split()[-2]
        if name in inner:
            continue
        message = f"'{name}' is created but never started"
        help = f"add {name} to the LaunchDescription, or remove it"
        yield Problem("LAU010", span, message, help, severity=Severity.INFO)


def dropped_directory(call: ast.Call, values: Values) -> Problem | None:
    """A part of a path that begins with a slash: the parts before it are dropped."""
    for part in parts_of_path(call)[1:]:
        text = string(part) or ""
        if text.startswith("/"):
            message = f"'{text}' begins with a slash, so the directories before it are dropped"
            help = f"write '{text.lstrip('/')}'"
            return Problem("LAU003", values.span(part), message, help, severity=Severity.ERROR)
    return None


def joined(call: ast.Call, values: Values) -> Problem | None:
    """A substitution in ``os.path.join``, which Python rejects, as its value is unknown."""
    function = call.func
    if not isinstance(function, ast.Attribute) or ast.unparse(function) != "os.path.join":
        return None
    for part in call.args:
        value = values.resolved(part)
        if isinstance(value, ast.Call) and called(value) in _SUBSTITUTIONS:
            message = f"os.path.join rejects {called(value)}: its value is known only at run time"
            help = "write PathJoinSubstitution([...]) with the same parts"
            return _rejected(part, message, help, values)
    return None


def entry_point(tree: ast.Module, source: Source) -> Iterator[Problem]:
    """The problem if the function that launch calls is missing or returns nothing."""
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    entries = [function for function in functions if function.name == _ENTRY]
    if entries and not _returns_value(entries[-1]):
        span = _name_of(entries[-1], source)
        message, help = f"{_ENTRY}() returns nothing", "return the LaunchDescription"
        yield Problem("LAU010", span, message, help, severity=Severity.ERROR)
    by_name = {function.name: function for function in functions}
    if _ENTRY.encode() not in source.data and (name := nearest(_ENTRY, by_name, CLOSE_TYPO)):
        span = _name_of(by_name[name], source)
        message, help = f"launch calls {_ENTRY}(), which is missing", f"write def {_ENTRY}()"
        yield Problem("LAU010", span, message, help, severity=Severity.ERROR)


def _name_of(function: ast.FunctionDef, source: Source) -> Span:
    """The name in the definition of a function."""
    start = source.offset(function.lineno, 1) + function.col_offset
    match = re.compile(rb"def\s+([^\s(]+)").match(source.data, start)
    return Span(source, *match.span(1)) if match else Span(source, start, start)


def _returns_value(function: ast.FunctionDef) -> bool:
    """True if a function returns a value, or does not return."""
    stack: list[ast.AST] = [*function.body]
    while stack:  # an expression may be too deep for recursion
        node = stack.pop()
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda, ast.ClassDef)):
            continue  # a nested function
        if isinstance(node, (ast.Raise, ast.Yield, ast.YieldFrom)):
            return True
        if isinstance(node, ast.Return) and node.value is not None:
            return True
        stack += ast.iter_child_nodes(node)
    return False


def _former(call: ast.Call, values: Values) -> Iterator[Problem]:
    for keyword in call.keywords:
        new = _FORMER.get(keyword.arg or "")
        if new and b"ROS_DISTRO" not in values.source.data:  # otherwise it depends on the version
            span = values.span(keyword.value)
            message = f"Node has no argument '{keyword.arg}' (supported up to Foxy)"
            yield Problem("LAU010", span, message, f"write {new}=", severity=Severity.INFO)


def _action_list(call: ast.Call, values: Values) -> Iterator[Problem]:
    position, name = _HOLDERS[called(call)]
    node = argument(call, position, name)
    value = values.resolved(node)
    if node is not None and isinstance(value, ast.Call) and called(value) in ACTIONS:
        message = f"{name} of {called(call)} is not a list of actions"
        yield _rejected(node, message, "write it in [ ]", values)
    for item in values.items(node) if isinstance(value, ast.List) else ():
        if item is not None and isinstance(values.resolved(item), ast.List):
            message = f"{name} of {called(call)} contains a list, but launch expects actions"
            yield _rejected(item, message, "write a * before it, or + between the lists", values)


def _process(call: ast.Call, values: Values) -> Iterator[Problem]:
    """A command line that is not a list with one word per item."""
    node = argument(call, 0, "cmd")
    command = values.resolved(node)
    yield from _words(node, values)
    if node is None or argument(call, None, "shell") is not None:
        return
    first = values.items(node)[:1]
    text = string(first[0]) if first else None
    if (line := string(command)) is not None:
        message = "cmd of ExecuteProcess is a string, which launch splits into letters"
        yield _rejected(node, message, f"write {line.split()}", values)
    elif text and " " in text.strip() and first[0] is not None:
        message = f"'{text}' is one word, so launch looks for a program with this name"
        yield _rejected(first[0], message, "write one item for each word, or shell=True", values)


def _source(call: ast.Call, values: Values) -> Iterator[Problem]:
    """A launch file with a format that its source does not read."""
    node = argument(call, 0, "launch_file_path")
    path = values.text(node) or ""
    name = called(call)
    for matching_source, suffixes in _SOURCES.items():
        if node is not None and path.endswith(suffixes) and not path.endswith(_SOURCES[name]):
            message = f"{name} does not read '{path.rpartition('/')[2]}'"
            yield _rejected(call.func, message, f"write {matching_source}", values)
    yield from missing_slash(values.items(node), values)


def missing_slash(pieces: Collection[ast.expr | None], values: Values) -> Iterator[Problem]:
    """A path after the directory of a package without a slash, which launch does not add."""
    for before, piece in pairwise(pieces):
        directory = values.resolved(before)
        text = string(piece) or ""
        is_package = isinstance(directory, ast.Call) and called(directory) in PACKAGE_DIRECTORY
        if piece is not None and is_package and text[:1].isalpha():
            message = f"'{text}' follows the directory of a package without a slash"
            yield _rejected(piece, message, f"write '/{text}'", values)


def added(node: ast.expr, values: Values) -> Problem | None:
    """A text and a substitution with a plus between them, which Python rejects."""
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.Add):
        return None
    sides = [values.resolved(side) for side in (node.left, node.right)]
    has_text = any(string(side) is not None for side in sides)
    names = [called(side) if isinstance(side, ast.Call) else "" for side in sides]
    substitution = next((name for name in names if name in _SUBSTITUTIONS), "")
    if not (substitution and has_text):
        return None
    message = f"a string and a {substitution} cannot be added: its value is known only at run time"
    return _rejected(node, message, "write both into a list, with a comma between them", values)


def formatted(node: ast.expr, values: Values) -> Problem | None:
    """A substitution in an f-string, which has the name of its class and not its value."""
    for part in node.values if isinstance(node, ast.JoinedStr) else ():
        value = values.resolved(part.value) if isinstance(part, ast.FormattedValue) else None
        if isinstance(value, ast.Call) and called(value) in _SUBSTITUTIONS:
            message = (
                f"an f-string does not have the value of {called(value)}, which is known only "
            )
            message += "at run time"
            return _rejected(node, message, "write a list: [text, substitution]", values)
    return None


def _lists(call: ast.Call, values: Values) -> Iterator[Problem]:
    for name, expected in _LISTS.items():
        node = argument(call, None, name)
        value = values.resolved(node)
        if node is not None and (string(value) is not None or isinstance(value, ast.Dict)):
            yield _rejected(node, f"{name} of Node is not {expected}", "write it in [ ]", values)
    pairs = argument(call, None, "remappings")
    for pair in values.items(pairs) if isinstance(values.resolved(pairs), ast.List) else ():
        if pair is not None and (text := string(pair)) is not None:
            names = tuple(text.split(":="))
            help = f"write {names}" if len(names) == 2 else "write ('from', 'to')"
            yield _rejected(pair, f"'{text}' in remappings is not a pair", help, values)


def _sets(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    """A set of a name and its value among the parameters."""
    for item in values.items(node) if node else ():
        if item is not None and isinstance(values.resolved(item), ast.Set):
            message = "this is a set, but launch expects a dictionary of parameters"
            yield _rejected(item, message, 'write a colon: {"name": value}', values)


def _without_package(call: ast.Call, values: Values) -> Iterator[Problem]:
    """A known executable without its package: launch looks for it in PATH."""
    name = values.text(argument(call, None, "executable")) or ""
    if any(keyword.arg in (None, "package") for keyword in call.keywords):
        return
    for package, executables in data("launch")["executables"].items():
        if name in executables.split():
            message = f"'{name}' has no package: launch looks for a program of this name"
            yield _rejected(call.func, message, f'write package="{package}"', values)


def _documents(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    """A parameter that is a document of xacro, or a method that is not called."""
    for item in values.items(node) if node else ():
        for _, value in values.pairs(item):
            text = values.resolved(value)
            is_method = isinstance(text, ast.Attribute) and text.attr in _TEXTS
            if is_method and isinstance(text, ast.Attribute):
                message = f"{text.attr} is a method, but launch expects a string"
                yield _rejected(value, message, f"write {text.attr}()", values)
            elif isinstance(text, ast.Call) and called(text) in _DOCUMENTS:
                message = f"{called(text)}() returns an XML document, but launch expects a string"
                yield _rejected(value, message, "append .toxml()", values)


def _words(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    for item in values.items(node) if node else ():
        yield from _text(item, "a word of the command line", values)
        if isinstance(item, ast.Constant) and _JOINED.match(source := values.span(item).text):
            message = f"{source} is one word: Python joins strings without a comma between them"
            yield _rejected(item, message, "write a comma between the two", values)


def _text(node: ast.expr | None, subject: str, values: Values) -> Iterator[Problem]:
    """A number or a boolean instead of a text."""
    value = values.resolved(node)
    if isinstance(value, ast.UnaryOp):
        value = value.operand
    if node is None or not isinstance(value, ast.Constant) or type(value.value) not in _SCALARS:
        return
    kind = type(value.value).__name__
    written = ast.unparse(node) if not isinstance(node, ast.Name) else value.value
    text = str(written).lower() if kind == "bool" else str(written)
    yield _rejected(
        node, f"{subject} is a {kind}, but launch expects a string", f"write '{text}'", values
    )


def _passed(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    arguments = values.resolved(node)
    if node is not None and isinstance(arguments, ast.Dict):
        yield _rejected(node, "launch_arguments is a dictionary", "append .items()", values)
    if isinstance(arguments, ast.Call) and isinstance(arguments.func, ast.Attribute):
        dictionary = arguments.func.value if arguments.func.attr == "items" else None
        for _, value in values.pairs(dictionary):
            yield from _text(value, "the value of a launch argument", values)


def _condition(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    text = string(values.resolved(node))
    if node is not None and text is not None and not _BOOLEAN.fullmatch(text):
        help = f"write LaunchConfiguration('{text}')"
        yield _rejected(node, f"condition '{text}' is neither true nor false", help, values)


def _rejected(node: ast.expr, message: str, help: str, values: Values) -> Problem:
    return Problem("LAU010", values.span(node), message, help, severity=Severity.ERROR)

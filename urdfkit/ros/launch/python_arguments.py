"""Arguments of calls in a Python launch file that launch rejects."""

import ast
import re
from collections.abc import Iterator

from urdfkit.ros.catalog import data
from urdfkit.ros.launch import is_python
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.launch_description import ACTIONS, HOLDERS
from urdfkit.ros.launch.python_expressions import missing_slash
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.python_source import string

#: Arguments of a call that must be lists, with their expected type.
_LISTS = {"arguments": "a list of words", "parameters": "a list", "remappings": "a list of pairs"}
_CONTAINERS = ("ComposableNodeContainer", "LoadComposableNodes")
_CONDITIONS = ("IfCondition", "UnlessCondition")
#: Suffixes of the files that each source of a launch description reads.
_SOURCES = {
    "PythonLaunchDescriptionSource": (".py",),
    "XMLLaunchDescriptionSource": (".xml", ".launch"),
    "YAMLLaunchDescriptionSource": (".yaml", ".yml"),
}
#: Names of Node's arguments until Foxy.
_FORMER = {"node_executable": "executable", "node_name": "name", "node_namespace": "namespace"}
#: Functions of xacro that return a document, whose text is required.
_DOCUMENTS = ("process_file", "parse")
_TEXTS = ("toxml", "toprettyxml")
#: Calls that pass arguments to xacro, with the position of their dictionary.
_MAPPED = {"robot_description": 1, "process_file": None, "process_doc": None}
#: An option and its value on one line, without a comma.
_JOINED = re.compile(r"""(["'])-[\w-]+\1[ \t]*["']""")
_BOOLEAN = re.compile(r"(?i)\s*(true|false|1|0)\s*")
#: Numbers and booleans, as launch accepts only texts and substitutions.
_SCALARS = (bool, int, float)


def wrong_arguments(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Arguments with a type that launch rejects when it creates an action."""
    if check := _CHECKS.get(called(call)):
        yield from check(call, values)


def _node(call: ast.Call, values: Values) -> Iterator[Problem]:
    yield from _lists(call, values)
    yield from _words(argument(call, None, "arguments"), values)
    yield from _values(argument(call, None, "parameters"), values)
    yield from _sets(argument(call, None, "parameters"), values)
    yield from _without_package(call, values)
    yield from _former(call, values)


def _former(call: ast.Call, values: Values) -> Iterator[Problem]:
    for keyword in call.keywords:
        new = _FORMER.get(keyword.arg or "")
        if new and b"ROS_DISTRO" not in values.source.data:  # otherwise it depends on the version
            message = f"Node has no argument '{keyword.arg}' (supported up to Foxy)"
            yield values.problem("LAU033", keyword.value, message, f"write {new}=", Severity.INFO)


def _action_list(call: ast.Call, values: Values) -> Iterator[Problem]:
    position, name = HOLDERS[called(call)]
    node = argument(call, position, name)
    value = values.resolved(node)
    if node is not None and called(value) in ACTIONS:
        message = f"{name} of {called(call)} is not a list of actions"
        yield values.problem("LAU033", node, message, "write it in [ ]")
    for item in values.items(node) if isinstance(value, ast.List) else ():
        if item is not None and isinstance(values.resolved(item), ast.List):
            message = f"{name} of {called(call)} contains a list, but launch expects actions"
            yield values.problem(
                "LAU033", item, message, "write a * before it, or + between the lists"
            )


def _components(call: ast.Call, values: Values) -> Iterator[Problem]:
    """Nodes in a container that are programs of their own."""
    nodes = argument(call, None, "composable_node_descriptions")
    for item in values.items(nodes) if nodes else ():
        if item is not None and called(values.resolved(item)) in ("Node", "LifecycleNode"):
            message = f"{called(call)} loads components, and this is a program of its own"
            help = "write ComposableNode, with plugin in place of executable"
            yield values.problem("LAU038", item, message, help)


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
        yield values.problem("LAU036", node, message, f"write {line.split()}")
    elif text and " " in text.strip() and first[0] is not None:
        message = f"'{text}' is one word, so launch looks for a program with this name"
        yield values.problem(
            "LAU036", first[0], message, "write one item for each word, or shell=True"
        )


def _source(call: ast.Call, values: Values) -> Iterator[Problem]:
    """A launch file with a format that its source does not read."""
    node = argument(call, 0, "launch_file_path")
    path = values.text(node) or ""
    name = called(call)
    for matching_source, suffixes in _SOURCES.items():
        is_of_other = path.endswith(suffixes) and not path.endswith(_SOURCES[name])
        if node is not None and is_of_other and not _is_program(path, values):
            message = f"{name} does not read '{path.rpartition('/')[2]}'"
            yield values.problem("LAU033", call.func, message, f"write {matching_source}")
    yield from missing_slash(values.items(node), values)


def _is_program(path: str, values: Values) -> bool:
    """True for a program with the suffix of XML, which launch runs whatever its name is."""
    source = values.collector.resolver.readable(path) if path.endswith(".launch") else None
    return source is not None and is_python(source)


def _declaration(call: ast.Call, values: Values) -> Iterator[Problem]:
    """A default that is no text, or none of the choices: launch stops at it."""
    node = argument(call, 1, "default_value")
    yield from _text(node, "default_value", values)
    default = string(values.resolved(node))
    listed = argument(call, None, "choices")
    choices = [string(values.resolved(item)) for item in values.items(listed)] if listed else []
    if node is None or default is None or not choices or None in choices or default in choices:
        return
    known = [choice for choice in choices if choice is not None]
    same = next((choice for choice in known if choice.lower() == default.lower()), None)
    help = f"write '{same}'" if same else f"add '{default}' to choices, or write one of them"
    message = f"default_value '{default}' is not one of the choices: {', '.join(known)}"
    yield values.problem("LAU033", node, message, help)


def _lists(call: ast.Call, values: Values) -> Iterator[Problem]:
    for name, expected in _LISTS.items():
        node = argument(call, None, name)
        value = values.resolved(node)
        if node is not None and (string(value) is not None or isinstance(value, ast.Dict)):
            yield values.problem(
                "LAU033", node, f"{name} of Node is not {expected}", "write it in [ ]"
            )
    pairs = argument(call, None, "remappings")
    for pair in values.items(pairs) if isinstance(values.resolved(pairs), ast.List) else ():
        if pair is not None and (text := string(pair)) is not None:
            names = tuple(text.split(":="))
            help = f"write {names}" if len(names) == 2 else "write ('from', 'to')"
            yield values.problem("LAU033", pair, f"'{text}' in remappings is not a pair", help)


def _sets(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    """A set of a name and its value among the parameters; one of a path is that of a file."""
    for item in values.items(node) if node else ():
        members = values.resolved(item) if item is not None else None
        if item is None or not isinstance(members, ast.Set):
            continue
        # launch joins the texts of any iterable to the path of a parameter file.
        if len(members.elts) > 1 or isinstance(members.elts[0], ast.Constant):
            message = "this is a set, but launch expects a dictionary of parameters"
            yield values.problem("LAU033", item, message, 'write a colon: {"name": value}')


def _without_package(call: ast.Call, values: Values) -> Iterator[Problem]:
    """A known executable without its package: launch looks for it in PATH."""
    name = values.text(argument(call, None, "executable")) or ""
    if any(keyword.arg in (None, "package") for keyword in call.keywords):
        return
    for package, executables in data("launch")["executables"].items():
        if name in executables.split():
            message = f"'{name}' has no package: launch looks for a program of this name"
            yield values.problem("LAU033", call.func, message, f'write package="{package}"')


def _values(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    """A parameter that is None, a list of mappings, a document or a method that is not called."""
    for item in values.items(node) if node else ():
        for key, value in values.pairs(item):
            text = values.resolved(value)
            name = values.text(key) or "the parameter"
            if isinstance(text, ast.Constant) and text.value is None:
                message = f"{name} is None, which launch rejects as a parameter"
                yield values.problem("LAU033", value, message, "write a value, or remove it")
            elif isinstance(value, ast.List) and not value.elts:  # others may be filled later
                message = f"{name} is an empty list, which launch rejects as a parameter"
                help = 'remove it; [""] has one empty text'
                yield values.problem("LAU033", value, message, help)
            elif isinstance(text, ast.List) and any(isinstance(e, ast.Dict) for e in text.elts):
                message = f"{name} is a list of dictionaries, which launch rejects as a parameter"
                yield values.problem(
                    "LAU033", value, message, "write a dictionary for each of them"
                )
            is_method = isinstance(text, ast.Attribute) and text.attr in _TEXTS
            if is_method and isinstance(text, ast.Attribute):
                message = f"{text.attr} is a method, but launch expects a string"
                yield values.problem("LAU033", value, message, f"write {text.attr}()")
            elif called(text) in _DOCUMENTS and not _is_of_another_module(text):
                message = f"{called(text)}() returns an XML document, but launch expects a string"
                yield values.problem("LAU033", value, message, "append .toxml()")


def _is_of_another_module(call: ast.expr | None) -> bool:
    """True for a function or method of something other than the module xacro."""
    function = call.func if isinstance(call, ast.Call) else None
    owner = function.value if isinstance(function, ast.Attribute) else None
    return owner is not None and not (isinstance(owner, ast.Name) and owner.id == "xacro")


def _words(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    for item in values.items(node) if node else ():
        yield from _text(item, "a word of the command line", values)
        if isinstance(item, ast.Constant) and _JOINED.match(source := values.span(item).text):
            message = f"{source} is one word: Python joins strings without a comma between them"
            yield values.problem("LAU036", item, message, "write a comma between the two")


def _text(
    node: ast.expr | None, subject: str, values: Values, reader: str = "launch"
) -> Iterator[Problem]:
    """A number or a boolean instead of a text."""
    value = values.resolved(node)
    if isinstance(value, ast.UnaryOp):
        value = value.operand
    if node is None or not isinstance(value, ast.Constant) or type(value.value) not in _SCALARS:
        return
    kind = type(value.value).__name__
    written = ast.unparse(node) if not isinstance(node, ast.Name) else value.value
    text = str(written).lower() if kind == "bool" else str(written)
    yield values.problem(
        "LAU033", node, f"{subject} is a {kind}, but {reader} expects a string", f"write '{text}'"
    )


def _passed(call: ast.Call, values: Values) -> Iterator[Problem]:
    node = argument(call, 1, "launch_arguments")
    arguments = values.resolved(node)
    if node is not None and isinstance(arguments, ast.Dict):
        yield values.problem("LAU033", node, "launch_arguments is a dictionary", "append .items()")
    if isinstance(arguments, ast.Call) and isinstance(arguments.func, ast.Attribute):
        dictionary = arguments.func.value if arguments.func.attr == "items" else None
        for _, value in values.pairs(dictionary):
            yield from _text(value, "the value of a launch argument", values)


def _mappings(call: ast.Call, values: Values) -> Iterator[Problem]:
    for _, value in values.pairs(argument(call, _MAPPED[called(call)], "mappings")):
        yield from _text(value, "the value of an argument of xacro", values, "xacro")


def _condition(call: ast.Call, values: Values) -> Iterator[Problem]:
    node = argument(call, 0, "predicate_expression")
    text = string(values.resolved(node))
    if node is not None and text is not None and not _BOOLEAN.fullmatch(text):
        help = f"write LaunchConfiguration('{text}')"
        yield values.problem("LAU033", node, f"condition '{text}' is neither true nor false", help)


#: What is checked of a call, by the name of the class or function.
_CHECKS = {
    "Node": _node,
    **dict.fromkeys(HOLDERS, _action_list),
    **dict.fromkeys(_CONTAINERS, _components),
    **dict.fromkeys(_SOURCES, _source),
    "ExecuteProcess": _process,
    "DeclareLaunchArgument": _declaration,
    "IncludeLaunchDescription": _passed,
    **dict.fromkeys(_MAPPED, _mappings),
    **dict.fromkeys(_CONDITIONS, _condition),
}

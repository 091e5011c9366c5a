"""Nodes and their parameters in launch files of Python."""

import ast
import re
from itertools import pairwise

from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.components import executable_of
from urdfkit.ros.launch.contents import (
    PARAMETERS,
    RVIZ,
    GivenParameters,
    StartedProgram,
    Word,
    file_of,
    with_words,
)
from urdfkit.ros.launch.moveit_builder import is_configuration, unknown_attribute
from urdfkit.ros.launch.moveit_parameters import (
    missing_of_move_group,
    missing_of_rviz,
    missing_of_servo,
)
from urdfkit.ros.launch.python_descriptions import named_by_argument, record_unexpanded
from urdfkit.ros.launch.python_file import PythonLaunchFile
from urdfkit.text.source import Span

_COMPONENT = "ComposableNode"
_ARGUMENTS = re.compile(r"^(?!(?:ros_)?arguments$).*arg")
_PARAMETER_FILES = (".yaml", ".yml")


def start_node(file: PythonLaunchFile, call: ast.Call) -> None:
    """Read a ``Node(...)``."""
    words = argument(call, None, "arguments")
    ros_arguments = argument(call, None, "ros_arguments")
    program = _program(file, call, is_whole=ros_arguments is None)
    if not program.package or "rviz" in program.package:
        _record_rviz_configuration(file, words)
    executable = argument(call, None, "executable") or argument(call, None, "node_executable")
    # ``**arguments``, or a wrong name of the arguments, which is reported.
    has_more = any(_ARGUMENTS.search(keyword.arg or "arg") for keyword in call.keywords)
    command = (Word(None, file.values.span(call)),) if has_more else file.values.words(words)
    options = [word.text for word in (*command, *file.values.words(ros_arguments))]
    if ros_arguments is not None:
        options.insert(len(command), "--ros-args")
    program = program._replace(
        executable=file.values.text(executable) or "",
        words=command,
        is_sure=file.is_sure(call),
        remappings=with_words(program.remappings, options, is_ros_2=True),
    )
    file.collector.start(program)
    if program.executable == "move_group":
        file.collector.problems += missing_of_move_group(file, call)
    elif program.package == "moveit_servo":
        file.collector.problems += missing_of_servo(file, call)
    elif program.package == "rviz2":
        file.collector.problems += missing_of_rviz(file, call)
    elif program.package == "robot_state_publisher":
        named_by_argument(file, call)


def start_components(file: PythonLaunchFile, container: ast.Call) -> None:
    """Read the composable nodes that a container, or an action of launch, loads."""
    descriptions = argument(container, None, "composable_node_descriptions")
    is_sure = file.is_sure(container)
    for item in file.values.items(descriptions) if descriptions else ():
        call = file.values.resolved(item)
        if isinstance(call, ast.Call) and called(call) == _COMPONENT:
            program = _program(file, call)._replace(
                executable=executable_of(file.values.text(argument(call, None, "plugin"))),
                is_sure=is_sure and file.is_sure(call),
                is_component=True,
            )
        else:
            program = StartedProgram("", "", (), file.values.span(container), file.frame, False)
        file.collector.start(program)


def _program(file: PythonLaunchFile, call: ast.Call, *, is_whole: bool = True) -> StartedProgram:
    """What nodes and composable nodes have in common; the files among it are recorded.

    Args:
        is_whole: False if the node gets further parameters.
    """
    package = _package(file, call)
    parameters = argument(call, None, "parameters")
    # The file that includes this one chooses other nodes: the parameters are for another robot.
    if not (file.frame and file.is_off(call)):
        _record_parameter_files(file, parameters)
    return StartedProgram(
        package,
        "",
        (),
        file.values.span(call),
        file.frame,
        remappings=_remappings(file, argument(call, None, "remappings")),
        parameters=_parameters(file, parameters, package, is_whole=is_whole),
        namespace=_namespace(file, call),
        name=file.values.text(argument(call, None, "name")) or "",
    )


def _package(file: PythonLaunchFile, call: ast.Call) -> str:
    """The package of a node, which is recorded; empty if it is known only at run time."""
    node = argument(call, None, "package")
    name = file.values.text(node)
    if name and node is not None:
        file.collector.started_package(name, file.source, file.values.span(node))
    return name or ""


def _record_rviz_configuration(file: PythonLaunchFile, words: ast.expr | None) -> None:
    for option, path in pairwise(file.values.items(words) if words else ()):
        if path and file.values.text(option) in ("-d", "--display-config"):
            file.record_file(path, RVIZ)


def _record_parameter_files(file: PythonLaunchFile, parameters: ast.expr | None) -> None:
    for item in file.values.items(parameters) if parameters else ():
        if item and (file.values.text(item) or "").endswith(_PARAMETER_FILES):
            file.record_file(item, PARAMETERS)


def _remappings(file: PythonLaunchFile, node: ast.expr | None) -> dict[str, str] | None:
    known: dict[str, str] = {}
    for item in file.values.items(node) if node else ():
        pair = file.values.resolved(item)
        names = pair.elts if isinstance(pair, (ast.List, ast.Tuple)) else []
        texts = [text for name in names if (text := file.values.text(name))]
        if len(texts) != 2:
            return None
        known[texts[0]] = texts[1]
    return known


def _namespace(file: PythonLaunchFile, call: ast.Call) -> str | None:
    written = argument(call, None, "namespace")
    text = "" if written is None else file.values.text(written)
    return None if text is None else text.strip("/")


def _parameters(
    file: PythonLaunchFile, node: ast.expr | None, package: str, *, is_whole: bool
) -> GivenParameters:
    """The parameters of a program of a package, in a list of dictionaries and files."""
    values: dict[str, str | None] = {}
    files: list[str] = []
    lists: dict[str, tuple[str | None, ...]] = {}
    at: dict[str, Span] = {}
    is_whole = is_of_moveit = is_whole and not file.values.grows(node)
    for item in file.values.items(node) if node else ():
        if isinstance(file.values.resolved(item), ast.Dict):
            is_whole = is_whole and not file.values.grows(item)
            for key, value in file.values.pairs(item):
                name = file.values.text(key)
                is_whole = is_whole and name is not None
                values[name or ""] = file.values.text(value)
                # A name may stand for a text, or for what launch parses.
                known = file.values.resolved(value)
                written = known if isinstance(known, ast.Constant) else value
                at[name or ""] = file.values.span(written)
                lists.update(_listed(file, name or "", value))
                _record_file_of(file, package, name or "", value)
        elif (file.values.text(item) or "").endswith(_PARAMETER_FILES):
            path = file.path(item)
            files += [path] if path else []
            is_whole = is_whole and path is not None
        else:
            is_whole = False
            is_of_moveit = is_of_moveit and is_configuration(item, file.values)
            file.collector.problems += unknown_attribute(item, file.values)
    values.pop("", None)
    is_of_moveit = is_of_moveit and not is_whole
    return GivenParameters(values, tuple(files), is_whole, lists, is_of_moveit, at)


def _listed(
    file: PythonLaunchFile, name: str, value: ast.expr
) -> dict[str, tuple[str | None, ...]]:
    """The items of parameters that are lists, by name."""
    items = file.values.items(value)
    is_list = isinstance(file.values.resolved(value), (ast.List, ast.Tuple)) or None not in items
    return {name: tuple(map(file.values.text, items))} if name and is_list else {}


def _record_file_of(file: PythonLaunchFile, package: str, name: str, value: ast.expr) -> None:
    """Record the file that is the value of a parameter, or whose text is the value."""
    if name == "robot_description" and file.frame is None:
        record_unexpanded(file, value)
    purpose = file_of(name, package)
    if purpose and file.values.text(value):
        file.record_file(value, purpose)

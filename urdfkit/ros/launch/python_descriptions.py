"""Robot descriptions that launch files of Python load."""

import ast
import os
from collections.abc import Collection, Iterator

from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.command_line import UNKNOWN_PART
from urdfkit.ros.launch.commands import missing_program, missing_space
from urdfkit.ros.launch.python_file import PythonLaunchFile

#: Greatest length of a command line that is read: one name may stand there thousands of times.
_MAX_LENGTH = 100_000


def untyped_commands(file: PythonLaunchFile) -> Iterator[ast.expr]:
    """The commands whose output becomes a parameter of a node without a type."""
    for node in file.calls:
        parameters = argument(node, None, "parameters") if called(node) == "Node" else None
        for item in file.values.items(parameters) if parameters else ():
            for _, value in file.values.pairs(item):
                command = file.values.resolved(value)
                if command is not None and called(command) == "Command":
                    yield command


def run_command(file: PythonLaunchFile, call: ast.Call, untyped: Collection[ast.expr]) -> None:
    """Read a ``Command(...)``, such as xacro."""
    command = argument(call, 0, "command")
    if mistake := missing_space(file.values, command):
        file.collector.problems.append(mistake)
        return
    text = file.values.text(command)
    items = file.values.items(command)
    if text is None or any(_is_open_path(file, item) for item in items):
        pieces = (None if _is_open_path(file, item) else file.values.text(item) for item in items)
        text = "".join(UNKNOWN_PART if piece is None else piece for piece in pieces)
    if text and len(text) <= _MAX_LENGTH:
        span, frame = file.values.span(call), file.call_frame(call)
        if mistake := missing_program(file.values, command, text):
            file.collector.problems.append(mistake)
            text = f"xacro {text}"
        file.collector.command(text, span, frame, is_yaml=call in untyped)


def _is_open_path(file: PythonLaunchFile, node: ast.expr | None) -> bool:
    """True for the path of a missing file with an argument in it that is still empty."""
    return (
        node is not None
        and os.path.isabs(file.values.text(node) or "")
        and file.lacks_argument(node)
    )


def run_process(file: PythonLaunchFile, call: ast.Call) -> None:
    """``subprocess.run(["xacro", path])``, whose output becomes a parameter."""
    command = argument(call, 0, "args")
    words = file.values.items(command)
    span, frame = file.values.span(call), file.call_frame(call)
    if None not in words:
        file.collector.expand([_word(file, word) for word in words], span, frame)
    elif text := file.values.text(command):
        file.collector.command(text, span, frame)


def _word(file: PythonLaunchFile, node: ast.expr | None) -> str:
    """A word of a command line, with ``UNKNOWN_PART`` for what is known only at run time."""
    text = file.values.text(node)
    if text is None and isinstance(node, ast.JoinedStr):
        return "".join(_word(file, part) for part in node.values)
    if text is None and isinstance(node, ast.BinOp):
        return _word(file, node.left) + _word(file, node.right)
    return UNKNOWN_PART if text is None else text


def process_file(file: PythonLaunchFile, call: ast.Call) -> None:
    """``xacro.process_file(path)``, or ``load_xacro(path)`` of launch_param_builder."""
    path, mappings = argument(call, 0, "input_file_name"), argument(call, None, "mappings")
    _describe(file, call, path, mappings)


def parse(file: PythonLaunchFile, call: ast.Call) -> None:
    """``xacro.parse(open(path))``, which ``xacro.process_doc`` expands."""
    opened = argument(call, 0, "inp")
    if isinstance(call.func, ast.Attribute) and isinstance(opened, ast.Call):
        module = call.func.value
        if isinstance(module, ast.Name) and module.id == "xacro" and called(opened) == "open":
            _describe(file, call, argument(opened, 0, "file"), _mappings_of(file, call))


def _mappings_of(file: PythonLaunchFile, parsing: ast.Call) -> ast.expr | None:
    """The arguments with which ``xacro.process_doc`` expands the document of a call."""
    for call in file.calls:
        if called(call) == "process_doc":
            document = argument(call, 0, "doc")
            if document is not None and file.values.resolved(document) is parsing:
                return argument(call, None, "mappings")
    return None


def open_file(file: PythonLaunchFile, call: ast.Call) -> None:
    """Record a plain URDF that is opened: its text becomes a parameter."""
    _describe_plain(file, call, argument(call, 0, "file"))


def read_text(file: PythonLaunchFile, call: ast.Call) -> None:
    """The same for ``Path(...).read_text()``."""
    if isinstance(call.func, ast.Attribute):
        _describe_plain(file, call, call.func.value)


def named_by_argument(file: PythonLaunchFile, publisher: ast.Call) -> None:
    """Record the URDF that robot_state_publisher reads as it has no parameter with the robot.

    Source: ``robot_state_publisher.cpp`` of ros/robot_state_publisher, "backwards compatibility".
    """
    words = file.values.items(argument(publisher, None, "arguments"))
    if words and words[0] is not None:
        _describe_plain(file, publisher, words[0])


def _describe_plain(file: PythonLaunchFile, call: ast.Call, path: ast.expr | None) -> None:
    if (file.values.text(path) or "").lower().endswith(".urdf"):
        _describe(file, call, path, None, is_expanded=False)


def record_unexpanded(file: PythonLaunchFile, value: ast.expr | None) -> None:
    """Record a xacro file whose unexpanded text becomes the robot description."""
    text = file.values.resolved(value)
    if isinstance(text, ast.Call) and called(text) == "ParameterValue":
        text = file.values.resolved(argument(text, 0, "value"))
    if not isinstance(text, ast.Call) or called(text) not in ("read", "read_text"):
        return
    read = text.func.value if isinstance(text.func, ast.Attribute) else None
    opened = file.values.opened(read) or file.values.resolved(read)
    if not isinstance(opened, ast.Call) or called(opened) not in ("open", "Path"):
        return
    if path := file.path(argument(opened, 0, "file")):
        file.collector.unexpanded(path, file.values.span(text), None)


def _describe(
    file: PythonLaunchFile,
    call: ast.Call,
    description: ast.expr | None,
    mappings: ast.expr | None,
    *,
    is_expanded: bool = True,
) -> None:
    path = file.path(description)
    if not path:
        return
    arguments = {
        file.values.text(key) or "": file.values.text(value)
        for key, value in file.values.pairs(mappings)
    }
    if mappings and not isinstance(file.values.resolved(mappings), ast.Dict):
        arguments[""] = None
    span, frame = file.values.span(call), file.call_frame(call)
    file.collector.description(path, arguments, span, frame, is_expanded=is_expanded)

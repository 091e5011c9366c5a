"""Launch files in Python, of ROS 2: read as a syntax tree, never run."""

import ast
import os
from collections.abc import Iterator
from itertools import pairwise

from urdfkit.core import disk
from urdfkit.ros.launch import moveit
from urdfkit.ros.launch.branches import decided_calls
from urdfkit.ros.launch.collect import Collector, frame_at, path_from
from urdfkit.ros.launch.command_line import UNKNOWN_PART
from urdfkit.ros.launch.commands import missing_space
from urdfkit.ros.launch.configurations import Configurations
from urdfkit.ros.launch.contents import (
    FILE_PARAMETERS,
    PARAMETERS,
    GivenParameters,
    IncludedFile,
    LaunchedFile,
    StartedProgram,
    with_words,
)
from urdfkit.ros.launch.event_handlers import never_reached, started_twice, wrong_targets
from urdfkit.ros.launch.python_calls import wrong_calls
from urdfkit.ros.launch.python_mistakes import (
    added,
    dropped_directory,
    entry_point,
    formatted,
    joined,
    mistakes,
    not_started,
)
from urdfkit.ros.launch.python_names import wrong_names
from urdfkit.ros.launch.scopes import unread, with_items
from urdfkit.ros.launch.signature import of_python
from urdfkit.ros.launch.values import Values, argument, called, parts_of_path
from urdfkit.text import python_source
from urdfkit.text.diagnostic import Problem
from urdfkit.text.document import CallFrame, Tag
from urdfkit.text.source import Span

_PARAMETER_FILES = (".yaml", ".yml")
#: Actions that apply to the nodes after them.
_SCOPES = (
    "PushRosNamespace", "PushROSNamespace", "SetParameter", "SetParametersFromFile", "SetRemap",
    "SetUseSimTime",
)  # fmt: skip


def read(collector: Collector, file: LaunchedFile) -> None:
    """Collect the contents of a launch file in Python, as far as they are constant."""
    source = file.source
    try:
        tree = python_source.parse(source.data, source.path)
    except SyntaxError as error:
        start = source.offset(error.lineno or 1, error.offset or 1)
        at = Span(source, start, start)
        collector.problems.append(Problem("LAU001", at, f"not a Python program: {error.msg}"))
        return
    _PythonReader(collector, file, tree).read()


class _PythonReader:
    """Reads the calls of a launch file that create actions."""

    def __init__(self, collector: Collector, file: LaunchedFile, tree: ast.Module) -> None:
        self.collector = collector
        self.source = file.source
        self.frame = file.frame
        self._tree = tree
        self.values = Values(collector, file, tree)
        self.calls = [node for node in python_source.nodes(tree) if isinstance(node, ast.Call)]
        #: Commands whose output becomes a parameter without a type.
        self._untyped: set[ast.expr] = set()
        #: True if actions may be in a group with a condition.
        self._has_groups = any(
            called(call) == "GroupAction" and argument(call, None, "condition")
            for call in self.calls
        )
        self._decided = decided_calls(tree)
        #: Actions in groups that these arguments switch off.
        self._off: set[ast.AST] = set()
        #: Expressions whose value is unused.
        self._idle = unread(tree)
        #: The same, and the items of unused lists.
        self._unused = with_items(self._idle)
        self.configurations = Configurations(self.values, of_python(tree), self.calls, self._unused)
        #: False for a part of a launch file, which another file completes.
        self._is_complete = any(called(call) == "LaunchDescription" for call in self.calls)
        self._expressions = [n for n in python_source.nodes(tree) if isinstance(n, ast.expr)]

    def read(self) -> None:
        for call in self.calls:
            if called(call) == "DeclareLaunchArgument":
                self._declare(call)
            elif called(call) == "Node":
                self._untyped.update(self._untyped_commands(call))
        for call in self.calls:
            if called(call) == "GroupAction" and self._condition(call) is False:
                self._off.update(ast.walk(call))
        handles = {
            "Command": self._command,
            "ExecuteProcess": self._process,
            "IncludeLaunchDescription": self._include,
            "Node": self._node,
            "open": self._open,
            "parse": self._parse,
            "process_file": self._process_file,
        }
        for call in self.calls:
            if handle := handles.get(called(call)):
                handle(call)
            elif called(call) in _SCOPES:
                self.collector.has_scopes = True
            else:
                moveit.record_files(call, self.values, self.collector)
        if self.frame is None:
            self._mistakes()
        self._mentions()
        self.collector.problems += self.configurations.undeclared()

    def _mistakes(self) -> None:
        """Problems of calls; an included file is reported when it is read itself."""
        problems = self.collector.problems
        for call in self.calls:
            if call not in self._idle:
                problems += mistakes(call, self.values)
            problem = dropped_directory(call, self.values) or joined(call, self.values)
            if problem:
                problems.append(problem)
        for node in self._expressions:
            if mistake := added(node, self.values) or formatted(node, self.values):
                problems.append(mistake)
        if self._is_complete:
            problems += not_started(self._idle, self.values)
            problems += entry_point(self._tree, self.source)
            problems += wrong_names(self._tree, self.values)
        problems += wrong_calls(self._tree, self.calls, self.values)
        problems += never_reached(self.calls, self.values)
        problems += started_twice(self.calls, self.values)
        problems += wrong_targets(self.calls, self.values)

    def _declare(self, call: ast.Call) -> None:
        if call in self._unused and self._is_complete:
            return  # it is not in a launch description
        name = self.values.text(argument(call, 0, "name"))
        default = argument(call, 1, "default_value")
        if name and default is not None:
            self.values.arguments.setdefault(name, default)

    def _mentions(self) -> None:
        """Record joined paths whose use is unknown, such as the path of a world."""
        for node in self._expressions:
            is_path = isinstance(node, (ast.BinOp, ast.JoinedStr)) or (
                isinstance(node, ast.Call) and bool(parts_of_path(node))
            )
            if is_path and node not in self._idle:
                path = self.values.text(node)
                if path and os.path.isabs(path):
                    self.collector.mention(path, self.values.span(node))

    # ---------------------------------------------------------------- calls

    def _node(self, call: ast.Call) -> None:
        if call in self._unused and self._is_complete:
            return  # it is not started
        package = argument(call, None, "package")
        name = self.values.text(package)
        if name and package is not None:
            self.collector.package(name, self.source, self.values.span(package))
        words = argument(call, None, "arguments")
        listed = self.values.items(words) if words else []
        for flag, value in pairwise(listed) if name is None or "rviz" in name else ():
            if value and self.values.text(flag) in ("-d", "--display-config"):
                self._file(value, "RViz configuration")
        parameters = argument(call, None, "parameters")
        # The file that includes this one chooses other nodes: the parameters are for another robot.
        is_off = self.frame and (call in self._off or self._condition(call) is False)
        for value in self.values.items(parameters) if parameters and not is_off else ():
            if value and (self.values.text(value) or "").endswith(_PARAMETER_FILES):
                self._file(value, PARAMETERS)
        executable = argument(call, None, "executable") or argument(call, None, "node_executable")
        command = self.values.words(words)
        ros_arguments = argument(call, None, "ros_arguments")
        options = [word.text for word in (*command, *self.values.words(ros_arguments))]
        if ros_arguments is not None:
            options.insert(len(command), "--ros-args")
        remappings = self._remappings(argument(call, None, "remappings"))
        program = StartedProgram(
            name or "",
            self.values.text(executable) or "",
            command,
            self.values.span(call),
            self.frame,
            is_sure=not self._has_groups and self._condition(call) is True,
            remappings=with_words(remappings, options, is_ros_2=True),
            parameters=self._parameters(parameters, ros_arguments),
            namespace=self._namespace(call),
            name=self.values.text(argument(call, None, "name")) or "",
        )
        self.collector.start(program)
        if program.executable == "move_group":
            problems = moveit.parameter_problems(call, self._tree, self.values, self.collector)
            self.collector.problems += problems
        elif program.package == "rviz2":
            problems = moveit.without_kinematics(call, self._tree, self.values, self.collector)
            self.collector.problems += problems

    def _remappings(self, node: ast.expr | None) -> dict[str, str] | None:
        known: dict[str, str] = {}
        for item in self.values.items(node) if node else ():
            pair = self.values.suggested(item)
            names = pair.elts if isinstance(pair, (ast.List, ast.Tuple)) else []
            texts = [text for name in names if (text := self.values.text(name))]
            if len(texts) != 2:
                return None
            known[texts[0]] = texts[1]
        return known

    def _namespace(self, call: ast.Call) -> str | None:
        written = argument(call, None, "namespace")
        text = "" if written is None else self.values.text(written)
        return None if text is None else text.strip("/")

    def _parameters(self, node: ast.expr | None, ros_arguments: ast.expr | None) -> GivenParameters:
        """The parameters in a list of dictionaries and files."""
        values: dict[str, str | None] = {}
        files: list[str] = []
        lists: dict[str, tuple[str | None, ...]] = {}
        is_whole = is_of_moveit = ros_arguments is None
        for item in self.values.items(node) if node else ():
            if isinstance(self.values.suggested(item), ast.Dict):
                for key, value in self.values.pairs(item):
                    name = self.values.text(key)
                    is_whole = is_whole and name is not None
                    values[name or ""] = self.values.text(value)
                    lists.update(self._listed(name or "", value))
                    self._note_files(name or "", value)
            elif (path := self.values.text(item) or "").endswith(_PARAMETER_FILES):
                file = self._path(path)
                files += [file] if file else []
                is_whole = is_whole and file is not None
            else:
                is_whole = False
                is_of_moveit = is_of_moveit and moveit.is_configuration(item, self.values)
        values.pop("", None)
        is_of_moveit = is_of_moveit and not is_whole
        return GivenParameters(values, tuple(files), is_whole, lists, is_of_moveit)

    def _listed(self, name: str, value: ast.expr) -> dict[str, tuple[str | None, ...]]:
        """The items of parameters that are lists, by name."""
        if not name or not isinstance(self.values.suggested(value), (ast.List, ast.Tuple)):
            return {}
        return {name: tuple(self.values.text(item) for item in self.values.items(value))}

    def _note_files(self, name: str, value: ast.expr) -> None:
        """Record the file that is the value of a parameter, or whose text is the value."""
        if name == "robot_description" and self.frame is None:
            self._unexpanded(value)
        if name in FILE_PARAMETERS and self.values.text(value):
            self._file(value, FILE_PARAMETERS[name])

    def _untyped_commands(self, node: ast.Call) -> Iterator[ast.expr]:
        parameters = argument(node, None, "parameters")
        for item in self.values.items(parameters) if parameters else ():
            for _, value in self.values.pairs(item):
                command = self.values.suggested(value)
                if isinstance(command, ast.Call) and called(command) == "Command":
                    yield command

    def _process(self, call: ast.Call) -> None:
        if call in self._unused and self._is_complete:
            return
        words = self.values.words(argument(call, 0, "cmd"))
        span = self.values.span(call)
        is_sure = not self._has_groups and self._condition(call) is True
        self.collector.started.append(StartedProgram("", "", words, span, self.frame, is_sure))

    def _include(self, call: ast.Call) -> None:
        node = argument(call, 0, "launch_description_source")
        path = self.values.text(node)
        path = (path and self._path(path)) or ""
        exists = False
        text = self.values.text(node)
        if node is not None and path:
            exists = self.collector.file(path, self.values.span(node), "included launch file")
        elif node is not None and text and self.frame is None and "/" in text:
            self._relative(text, node, "launch file")
        self.collector.problems += self.configurations.include(call, path)
        visible = self.configurations.visible(call)
        holds = self._condition(call)
        if holds is False:
            return
        is_sure = holds is True and not self._has_groups
        if visible is None or not exists:
            self.collector.unread.append(path)
        if path:
            included = IncludedFile(path, visible, self.values.span(call), self.frame, is_sure)
            self.collector.include(included)
        if exists and visible is not None:
            passed = {name: word.text for name, word in visible.items()}
            self.collector.follow(path, self.source, passed, self._frame(call), is_sure=is_sure)

    def _condition(self, action: ast.Call) -> bool | None:
        """Value of the condition of an action; None if known only at run time."""
        written = argument(action, None, "condition")
        if written is None:
            return None if action in self._decided else True
        condition = self.values.suggested(written)
        if not isinstance(condition, ast.Call):
            return None
        value = (self.values.text(argument(condition, 0, "predicate_expression")) or "").lower()
        holds = {"true": True, "1": True, "false": False, "0": False}.get(value)
        if holds is None or called(condition) not in ("IfCondition", "UnlessCondition"):
            return None
        if holds is (called(condition) != "IfCondition"):
            return False
        return None if action in self._decided else True

    def _command(self, call: ast.Call) -> None:
        command = argument(call, 0, "command")
        if mistake := missing_space(self.values, command):
            self.collector.problems.append(mistake)
            return
        text = self.values.text(command)
        if text is None:
            pieces = (self.values.text(piece) for piece in self.values.items(command))
            text = "".join(UNKNOWN_PART if piece is None else piece for piece in pieces)
        if text:
            is_yaml = call in self._untyped
            span, frame = self.values.span(call), self._frame(call)
            self.collector.command(text, span, frame, is_yaml=is_yaml)

    def _process_file(self, call: ast.Call) -> None:
        """``xacro.process_file(path)``."""
        file, mappings = argument(call, 0, "input_file_name"), argument(call, None, "mappings")
        self._describe(call, file, mappings)

    def _parse(self, call: ast.Call) -> None:
        """``xacro.parse(open(path))``, which ``xacro.process_doc`` expands."""
        file = argument(call, 0, "inp")
        if isinstance(call.func, ast.Attribute) and isinstance(file, ast.Call):
            module = call.func.value
            if isinstance(module, ast.Name) and module.id == "xacro" and called(file) == "open":
                self._describe(call, argument(file, 0, "file"), self._mappings_of(call))

    def _mappings_of(self, parsing: ast.Call) -> ast.expr | None:
        """The arguments with which ``xacro.process_doc`` expands the document of a call."""
        for call in self.calls:
            if called(call) == "process_doc":
                document = argument(call, 0, "doc")
                if document is not None and self.values.suggested(document) is parsing:
                    return argument(call, None, "mappings")
        return None

    def _open(self, call: ast.Call) -> None:
        """Record a plain URDF whose text becomes a parameter."""
        file = argument(call, 0, "file")
        if (self.values.text(file) or "").endswith(".urdf"):
            self._describe(call, file, is_expanded=False)

    def _unexpanded(self, value: ast.expr | None) -> None:
        """Record a xacro file whose unexpanded text becomes the robot description."""
        text = self.values.suggested(value)
        if isinstance(text, ast.Call) and called(text) == "ParameterValue":
            text = self.values.suggested(argument(text, 0, "value"))
        if not isinstance(text, ast.Call) or called(text) not in ("read", "read_text"):
            return
        file = text.func.value if isinstance(text.func, ast.Attribute) else None
        opened = self.values.opened(file) or self.values.suggested(file)
        if isinstance(opened, ast.Call) and called(opened) in ("open", "Path"):
            path = self.values.text(argument(opened, 0, "file"))
            resolved = path and self._path(path)
            if resolved:
                self.collector.unexpanded(resolved, self.values.span(text), None)

    def _describe(
        self,
        call: ast.Call,
        file: ast.expr | None,
        mappings_node: ast.expr | None = None,
        *,
        is_expanded: bool = True,
    ) -> None:
        text = self.values.text(file)
        path = text and self._path(text)
        if not path:
            return
        arguments = {
            self.values.text(key) or "": self.values.text(value)
            for key, value in self.values.pairs(mappings_node)
        }
        if mappings_node and not isinstance(self.values.suggested(mappings_node), ast.Dict):
            arguments[""] = None
        span = self.values.span(call)
        frame = self._frame(call)
        self.collector.description(path, arguments, span, frame, is_expanded=is_expanded)

    def _frame(self, call: ast.Call) -> CallFrame:
        start = self.values.span(call).start
        return frame_at(self.source, Tag(self.source, start, start), self.frame)

    def _file(self, node: ast.expr, purpose: str) -> None:
        text = self.values.text(node)
        path = text and self._path(text)
        if path:
            self.collector.file(path, self.values.span(node), purpose)
        elif text and self.frame is None:
            self._relative(text, node, purpose)

    def _relative(self, text: str, node: ast.expr, purpose: str) -> None:
        """Report a path that is only found from one working directory."""
        if text.startswith(("~", "$", "package://", "file://")):
            return
        package = self.collector.resolver.packages.enclosing(self.source.path)
        name = package[0] if package else "PACKAGE"
        message = f"{purpose} '{text}' is looked for where launch is started, not in the package"
        help = f'write os.path.join(get_package_share_directory("{name}"), "{text}")'
        problem = Problem("LAU003", self.values.span(node), message, help)
        self.collector.problems.append(problem)

    def _path(self, text: str) -> str | None:
        """An absolute path; None for a relative path: the working directory is unknown."""
        path = path_from(self.source, text)
        return path if os.path.isabs(text) or disk.exists(path) else None

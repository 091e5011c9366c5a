"""Launch files in Python, of ROS 2: read as a syntax tree, never run."""

import ast
import os
from collections.abc import Callable
from functools import partial
from itertools import filterfalse

from urdfkit.ros.launch.calls import argument, called, parts_of_path
from urdfkit.ros.launch.collect import SIM_TIME, Collector
from urdfkit.ros.launch.command_line import UNKNOWN_PART, command_words
from urdfkit.ros.launch.configurations import Configurations
from urdfkit.ros.launch.contents import (
    INCLUDED,
    EnvironmentSetting,
    IncludedFile,
    LaunchedFile,
    Word,
    started_process,
)
from urdfkit.ros.launch.description_loaders import with_loaders
from urdfkit.ros.launch.event_handlers import waits_for_unstarted, wrong_handlers
from urdfkit.ros.launch.forwarding import file_of_action
from urdfkit.ros.launch.launch_description import entry_point, not_started
from urdfkit.ros.launch.moveit_builder import record_files
from urdfkit.ros.launch.python_arguments import wrong_arguments
from urdfkit.ros.launch.python_calls import wrong_calls
from urdfkit.ros.launch.python_descriptions import (
    open_file,
    parse,
    process_file,
    read_text,
    run_command,
    run_process,
    untyped_commands,
)
from urdfkit.ros.launch.python_expressions import wrong_expressions
from urdfkit.ros.launch.python_file import NODES, PythonLaunchFile
from urdfkit.ros.launch.python_loads import loading_functions, record_loaded, record_parameters
from urdfkit.ros.launch.python_names import wrong_names
from urdfkit.ros.launch.python_nodes import start_components, start_node
from urdfkit.ros.launch.python_order import declared_late
from urdfkit.ros.launch.repeated_calls import with_copies
from urdfkit.ros.launch.scopes import overwritten, unread, with_items
from urdfkit.ros.launch.signature import of_python
from urdfkit.ros.launch.unrolled_loops import without_loops
from urdfkit.text import python_source
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Span
from urdfkit.workspace.resolve import Resolver

#: Actions that set the namespace of the nodes after them.
_PUSHING = ("PushRosNamespace", "PushROSNamespace")
#: Actions that apply to the nodes after them.
_SCOPES = (*_PUSHING, "SetParameter", "SetParametersFromFile", "SetRemap", "SetUseSimTime")

#: Actions that set or extend a variable of the environment.
_SETTING = ("AppendEnvironmentVariable", "SetEnvironmentVariable")
#: A loop over the arguments of a function is known when the function has a copy for each call.
_MAX_ROUNDS = 5

#: Functions and methods that look for a file.
_LOOKING = ("exists", "is_file", "isfile")
#: Functions of ``subprocess`` and ``os`` that return the output of a command.
_PROCESSES = ("Popen", "check_output", "getoutput", "popen", "run")


def read(collector: Collector, file: LaunchedFile) -> None:
    """Collect the contents of a launch file in Python, as far as they are constant."""
    source = file.source
    try:
        written = python_source.parse(source.data, source.path)
    except SyntaxError as error:
        start = source.offset(error.lineno or 1, error.offset or 1)
        at = Span(source, start, start)
        collector.problems.append(Problem("LAU001", at, f"not a Python program: {error.msg}"))
        return
    loaded = with_loaders(written, partial(_module, collector.resolver, source.path))
    tree = _unrolled(loaded)
    # What another module returns has names that this one does not define.
    _PythonReader(collector, file, tree, tree if loaded is written else written).read()


def _module(resolver: Resolver, near: str, name: str) -> ast.Module | None:
    """A Python module of a package of the workspace, such as ``arm_description.loader``."""
    package, _, inside = name.partition(".")
    directory = resolver.packages.known(near).get(package)
    path = os.path.join(directory or "", package, *inside.split(".")) + ".py"
    source = resolver.readable(path) if directory else None
    try:
        return python_source.parse(source.data, path) if source else None
    except SyntaxError:
        return None


def _unrolled(tree: ast.Module) -> ast.Module:
    """The tree with one copy of each function for each call, and of loops for each item."""
    for _ in range(_MAX_ROUNDS):
        before, tree = tree, with_copies(without_loops(tree))
        if tree is before:
            break
    return tree


class _PythonReader(PythonLaunchFile):
    """Reads the calls of a launch file that create actions."""

    def __init__(
        self, collector: Collector, file: LaunchedFile, tree: ast.Module, written: ast.Module
    ) -> None:
        super().__init__(collector, file, tree)
        self._written = written
        #: Expressions whose value is unused, and of these those that others replace.
        self._overwritten = overwritten(tree)
        self._idle = unread(tree) | self._overwritten
        #: The same, and the items of unused lists.
        self._unused = with_items(self._idle)
        self.configurations = Configurations(self.values, of_python(tree), self.calls, self._unused)
        #: False for a part of a launch file, which another file completes.
        self._is_complete = any(called(call) == "LaunchDescription" for call in self.calls)
        self._expressions = [n for n in python_source.nodes(tree) if isinstance(n, ast.expr)]

    def read(self) -> None:
        for call in self.calls:
            if called(call) == "DeclareLaunchArgument" and self._may_run(call):
                self._declare(call)
        self._read_calls()
        if self.frame is None:
            self._report_problems()
        self._mentions()
        self.collector.problems += self.configurations.undeclared()

    def _read_calls(self) -> None:
        untyped = set(untyped_commands(self))
        starts: dict[str, Callable[[ast.Call], None]] = {
            "ComposableNodeContainer": partial(start_components, self),
            "ExecuteProcess": self._process,
            "IncludeLaunchDescription": self._include,
            "LoadComposableNodes": partial(start_components, self),
            **dict.fromkeys(NODES, partial(start_node, self)),
        }
        handles: dict[str, Callable[[ast.Call], None]] = {
            **dict.fromkeys(_SETTING, self._set_environment),
            "Command": partial(run_command, self, untyped=untyped),
            "open": partial(open_file, self),
            "parse": partial(parse, self),
            "load_xacro": partial(process_file, self),
            "process_file": partial(process_file, self),
            "read_text": partial(read_text, self),
            "yaml": partial(record_parameters, self),
            **dict.fromkeys(_LOOKING, self._look),
            **dict.fromkeys(_PROCESSES, partial(run_process, self)),
        }
        loading = dict.fromkeys(loading_functions(self.tree), partial(record_loaded, self))
        handles = {**loading, **handles}
        for call in filterfalse(self.only_of_never().__contains__, self.calls):
            name = called(call)
            if start := starts.get(name):
                if self._may_run(call):
                    with self.values.without(self.chosen_otherwise(call)):
                        start(call)
            elif handle := handles.get(name):
                handle(call)
            elif file_of_action(name):
                self._action(call)
            elif name in _SCOPES:
                self._scope(call)
            else:
                record_files(call, self.values, self.collector)

    def _look(self, call: ast.Call) -> None:
        """A path whose file may be missing, since the program looks for it."""
        owner = call.func.value if isinstance(call.func, ast.Attribute) else None
        if path := self.path(call.args[0] if call.args else owner):
            self.collector.optional.add(path)

    def _may_run(self, action: ast.Call) -> bool:
        """False for an action that is not in a launch description, or switched off in this one."""
        is_used = action not in self._unused or not self._is_complete
        return is_used and not self.is_never(action)

    def _report_problems(self) -> None:
        """Problems of calls; an included file is reported when it is read itself."""
        problems = self.collector.problems
        for call in self.calls:
            if call not in self._idle:
                problems += wrong_arguments(call, self.values)
        problems += wrong_expressions(self._expressions, self.values)
        used = self.calls
        if self._is_complete:
            problems += not_started(self._idle - self._overwritten, self.values)
            idle = {node for call in self._idle for node in ast.walk(call)}
            used = [call for call in self.calls if call not in idle]
            problems += waits_for_unstarted(self._expressions, used, self.values)
            problems += entry_point(self.tree, self.source)
            problems += wrong_names(self._written, self.values)
        problems += wrong_calls(self.tree, self.calls, self.values)
        problems += declared_late(self.calls, self.values)
        problems += wrong_handlers(used, self.values)

    def _declare(self, call: ast.Call) -> None:
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

    def _set_environment(self, call: ast.Call) -> None:
        value = argument(call, 1, "value")
        name = self.values.text(argument(call, 0, "name"))
        if name and value is not None:
            word = Word(self.values.text(value), self.values.span(value))
            self.collector.environment.append(EnvironmentSetting(name, word))

    def _scope(self, call: ast.Call) -> None:
        name = called(call)
        first = self.values.text(argument(call, 0, "namespace" if name in _PUSHING else "name"))
        if self.is_off(call) or (name in _PUSHING and first == ""):
            return  # often the namespace of an argument that is empty by default
        is_parameter = name == "SetParameter" and first == SIM_TIME
        self.collector.scope(of_sim_time=is_parameter or name == "SetUseSimTime")

    def _action(self, call: ast.Call) -> None:
        """Read an action of ros_gz, which includes a launch file."""
        if not self._may_run(call) or self.is_off(call):
            return
        words: dict[str, Word] | None = {
            keyword.arg or "": Word(
                self.values.text(keyword.value), self.values.span(keyword.value)
            )
            for keyword in call.keywords
        }
        if words and "" in words:
            words = None
        span, is_sure = self.values.span(call), self.is_sure(call)
        self.collector.action(called(call), words, span, self.frame, is_sure=is_sure)

    def _process(self, call: ast.Call) -> None:
        words = self.values.words(argument(call, 0, "cmd"))
        if argument(call, None, "shell") is not None and words:  # launch joins them
            line = " ".join(word.text or UNKNOWN_PART for word in words)
            texts = (None if UNKNOWN_PART in text else text for text in command_words(line))
            words = tuple(Word(text, words[0].span) for text in texts)
        span, is_sure = self.values.span(call), self.is_sure(call)
        self.collector.start(started_process(words, span, self.frame, is_sure))

    def _include(self, call: ast.Call) -> None:
        node = argument(call, 0, "launch_description_source")
        path = self.path(node) or ""
        exists = False
        if node is not None and path:
            exists = self.collector.file(path, self.values.span(node), INCLUDED)
        elif node is not None and "/" in (self.values.text(node) or ""):
            self.report_relative(node, "launch file")
        self.collector.problems += self.configurations.include(call, path)
        visible = self.configurations.visible(call)
        if self.is_off(call):
            return
        if visible is None or not exists:
            self.collector.not_read(path)
        is_sure = self.is_sure(call)
        if path:
            included = IncludedFile(path, visible, self.values.span(call), self.frame, is_sure)
            self.collector.include(included)
        if exists and visible is not None:
            passed = {name: word.text for name, word in visible.items()}
            frame = self.call_frame(call)
            fixed = self.configurations.fixed(call)
            self.collector.follow(path, self.source, passed, frame, is_sure=is_sure, fixed=fixed)

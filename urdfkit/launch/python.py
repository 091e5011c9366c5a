"""Launch files in Python, of ROS 2: read as a syntax tree, never run."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator

from urdfkit.document import Tag
from urdfkit.launch.collect import UNKNOWN, Collector, frame_at
from urdfkit.launch.found import PARAMETERS, Launch
from urdfkit.reading import Problem
from urdfkit.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: Expressions inside one another that are followed.
MAX_DEPTH = 40

_PACKAGE_FOLDER = ("get_package_share_directory", "FindPackageShare", "get_package_share_path")
_JOINED = ("PathJoinSubstitution", "join", "joinpath")
_PARAMETER_FILES = (".yaml", ".yml")
_PASSED_ON = (
    "ParameterValue", "TextSubstitution", "PythonLaunchDescriptionSource", "str", "Path",
    "XMLLaunchDescriptionSource", "AnyLaunchDescriptionSource", "ParameterFile", "abspath",
)  # fmt: skip


def read(source: Source, resolver: Resolver, arguments: dict[str, str]) -> Launch:
    """What a launch file in Python needs, as far as constants reach."""
    collector = Collector(resolver)
    try:
        tree = ast.parse(source.data, source.path)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        line, column = getattr(error, "lineno", 1) or 1, getattr(error, "offset", 1) or 1
        start = source.offset(line, column)
        reason = getattr(error, "msg", None) or str(error) or type(error).__name__
        at = Span(source, start, start)
        collector.problems.append(Problem("LAU001", at, f"not a Python program: {reason}"))
        return collector.launch()
    _Reader(collector, source, tree, arguments).read()
    return collector.launch()


class _Reader:
    """Follows constants through one launch file."""

    def __init__(
        self, collector: Collector, source: Source, tree: ast.Module, arguments: dict[str, str]
    ) -> None:
        self.collector = collector
        self.source = source
        self.nodes = list(ast.walk(tree))
        self.values: dict[str, ast.expr] = {}
        self.arguments: dict[str, ast.expr | str] = dict(arguments)

    def read(self) -> None:
        for node in self.nodes:
            if isinstance(node, ast.Assign) and len(node.targets) == 1:
                target = node.targets[0]
                if isinstance(target, ast.Name):
                    self.values[target.id] = node.value
        calls = [node for node in self.nodes if isinstance(node, ast.Call)]
        for call in calls:
            if _name(call) == "DeclareLaunchArgument":
                self._declare(call)
        for call in calls:
            handle = getattr(self, f"_{_name(call)}", None)
            if handle is not None:
                handle(call)

    def _declare(self, call: ast.Call) -> None:
        name = self.text(_argument(call, 0, "name"))
        default = _argument(call, None, "default_value")
        if name and default is not None:
            self.arguments.setdefault(name, default)

    # ---------------------------------------------------------------- calls

    def _Node(self, call: ast.Call) -> None:  # noqa: N802 - the names of launch_ros
        package = _argument(call, None, "package")
        name = self.text(package)
        if name and package is not None:
            self.collector.package(name, self.source, self._span(package))
        words = _argument(call, None, "arguments")
        if isinstance(words, (ast.List, ast.Tuple)):
            for flag, value in zip(words.elts, words.elts[1:], strict=False):
                if self.text(flag) in ("-d", "--display-config"):
                    self._file(value, "the RViz configuration")

        parameters = _argument(call, None, "parameters")
        for value in parameters.elts if isinstance(parameters, ast.List) else ():
            if (self.text(value) or "").endswith(_PARAMETER_FILES):
                self._file(value, PARAMETERS)

    def _IncludeLaunchDescription(self, call: ast.Call) -> None:  # noqa: N802
        if call.args:
            self._file(call.args[0], "the included launch file")

    def _Command(self, call: ast.Call) -> None:  # noqa: N802
        text = self.text(_argument(call, 0, "command"))
        if text is not None:
            span = self._span(call)
            tag = Tag(self.source, span.start, span.start)
            self.collector.command(text, span, frame_at(self.source, tag, None))

    def _process_file(self, call: ast.Call) -> None:
        path = self.text(_argument(call, 0, "input_file_name"))
        if path is None:
            return
        mappings = _argument(call, None, "mappings")
        arguments: dict[str, str] = {}
        if isinstance(mappings, ast.Dict):
            for key, value in zip(mappings.keys, mappings.values, strict=True):
                name, text = self.text(key), self.text(value)
                if name and text is not None:
                    arguments[name] = text
        span = self._span(call)
        tag = Tag(self.source, span.start, span.start)
        frame = frame_at(self.source, tag, None)
        self.collector.description(self._path(path), arguments, span, frame)

    def _file(self, node: ast.expr, purpose: str) -> None:
        path = self.text(node)
        if path is not None:
            self.collector.file(self._path(path), self._span(node), purpose)

    def _path(self, text: str) -> str:
        folder = os.path.dirname(os.path.abspath(self.source.path))
        return os.path.normpath(os.path.join(folder, text))

    # --------------------------------------------------------------- values

    def text(self, node: ast.expr | None, depth: int = 0) -> str | None:
        """The text that an expression gives; None where only running it would tell."""
        if node is None or depth > MAX_DEPTH:
            return None
        if isinstance(node, ast.Constant):
            return str(node.value) if isinstance(node.value, (str, int, float)) else None
        if isinstance(node, ast.Name):
            return self._of_name(node.id, depth)
        if isinstance(node, (ast.List, ast.Tuple)):
            return _joined(self.text(item, depth + 1) for item in node.elts)
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Div)):
            between = os.sep if isinstance(node.op, ast.Div) else ""
            return _joined((self.text(n, depth + 1) for n in (node.left, node.right)), between)
        if isinstance(node, ast.JoinedStr):
            return _joined(self.text(part, depth + 1) for part in node.values)
        if isinstance(node, ast.FormattedValue):
            return self.text(node.value, depth + 1)
        return self._of_call(node, depth) if isinstance(node, ast.Call) else None

    def _of_name(self, name: str, depth: int) -> str | None:
        value = self.values.get(name)
        return None if value is None else self.text(value, depth + 1)

    def _of_call(self, call: ast.Call, depth: int) -> str | None:
        name = _name(call)
        if name in _PACKAGE_FOLDER:
            package = self.text(_argument(call, 0, "package"), depth + 1)
            if package is None:
                return None
            folder = self.collector.package(package, self.source, self._span(call))
            return f"{UNKNOWN}/{package}" if folder is None else folder
        if name in _JOINED:
            parts = list(call.args)
            if len(parts) == 1 and isinstance(parts[0], (ast.List, ast.Tuple)):
                parts = list(parts[0].elts)
            return _joined((self.text(part, depth + 1) for part in parts), os.sep)
        if name == "LaunchConfiguration":
            return self._of_configuration(call, depth)
        if name == "FindExecutable":
            return self.text(_argument(call, 0, "name"), depth + 1)
        if name in _PASSED_ON and call.args:
            return self.text(call.args[0], depth + 1)
        return None

    def _of_configuration(self, call: ast.Call, depth: int) -> str | None:
        name = self.text(_argument(call, 0, "variable_name"), depth + 1)
        value = self.arguments.get(name or "")
        return value if isinstance(value, str) else self.text(value, depth + 1)

    def _span(self, node: ast.expr) -> Span:
        """The place of a node; ast counts columns in bytes of UTF-8."""
        starts = self.source.offset(node.lineno, 1) + node.col_offset
        end_line, end_column = node.end_lineno or node.lineno, node.end_col_offset or 0
        return Span(self.source, starts, self.source.offset(end_line, 1) + end_column)


def _name(call: ast.Call) -> str:
    """The last part of what is called."""
    function = call.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _argument(call: ast.Call, position: int | None, name: str) -> ast.expr | None:
    for keyword in call.keywords:
        if keyword.arg == name:
            return keyword.value
    if position is not None and position < len(call.args):
        return call.args[position]
    return None


def _joined(parts: Iterator[str | None], between: str = "") -> str | None:
    texts: list[str] = []
    for part in parts:
        if part is None:
            return None
        texts.append(part)
    return between.join(texts)

"""MoveIt's configuration in Python launch files: ``MoveItConfigsBuilder``, and dictionaries.

Sources: ``moveit_configs_builder.py`` of moveit_configs_utils, ``planning_pipeline.cpp`` and
``kinematics_plugin_loader.cpp`` of moveit/moveit2.
"""

import ast
import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UnreadableFile, UrdfkitError
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.collect import UNKNOWN, Collector, frame_at
from urdfkit.ros.launch.contents import MOVEIT, LaunchedDescription
from urdfkit.ros.launch.values import Values, argument, called
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import Tag
from urdfkit.text.located_yaml import Key, Node, load, mapping
from urdfkit.text.source import Span

#: Methods whose first argument is a file of the package.
_FILES = (
    "joint_limits", "moveit_cpp", "pilz_cartesian_limits", "robot_description",
    "robot_description_kinematics", "robot_description_semantic", "sensors_3d",
    "trajectory_execution",
)  # fmt: skip
#: Pipelines for which moveit_configs_utils has settings.
_PIPELINES = ("chomp", "ompl", "pilz_industrial_motion_planner", "stomp")

_PILZ = "pilz_industrial_motion_planner"
#: The end of the name of a file of controllers.
_CONTROLLERS = "_controllers.yaml"
#: The display of RViz that has interactive markers for the end effectors.
_DISPLAY = b"moveit_rviz_plugin/MotionPlanning"
_DESCRIPTION = "robot_description"
_SEMANTIC = "robot_description_semantic"
_KINEMATICS = "robot_description_kinematics"
_SECTION = "ros__parameters"
_SOLVER = ".kinematics_solver"
#: Statements that change a dictionary after its creation.
_CHANGES = re.compile(rb"\.update\(|\]\s*=[^=]|\|=")
#: Launches of moveit_configs_utils that need no planner.
_NO_PLANNER = re.compile(
    rb"\bgenerate_(moveit_rviz|rsp|setup_assistant|spawn_controllers|static_virtual_joint_tfs"
    rb"|warehouse_db)_launch\("
)
#: Those that need one, and what is passed on to other programs.
_PLANNER = re.compile(
    rb"\bgenerate_(demo|move_group)_launch\(|\.(to_dict\(|planning_pipelines\b(?!\s*\())"
)
_LOADS = ("safe_load", "load", "full_load")
#: Placeholder of unknown keys.
_OPEN = "*"


def record_files(call: ast.Call, values: Values, collector: Collector) -> None:
    """Record the files that a method of the builder reads, and its package."""
    builder = _builder(call)
    if builder is None:
        return
    robot = values.text(argument(builder, 0, "robot_name"))
    written = argument(builder, 1, "package_name")
    package = values.text(written) if written else robot and f"{robot}_moveit_config"
    if not package:
        return
    directory = collector.package(package, values.source, values.span(written or builder))
    if called(call) == "robot_description":
        _describe(call, directory or "", values, collector)
    if called(call) in _FILES:
        _given_file(call, directory or f"{UNKNOWN}/{package}", values, collector)
    elif called(call) == "to_moveit_configs" and directory:
        _default_files(call, directory, values, collector)
        _required_files(call, builder, directory, values, collector)
    elif called(call) == "planning_pipelines" and directory:
        _default(call, values, collector)
        _named_pipelines(call, directory, values, collector)


def _given_file(call: ast.Call, directory: str, values: Values, collector: Collector) -> None:
    """Record the file of a method of the builder, and report names that the builder adds."""
    node = argument(call, 0, "file_path")
    path = values.text(node)
    if node is not None and path and not path.startswith(UNKNOWN):
        path = os.path.normpath(os.path.join(directory, path))
        if collector.file(path, values.span(node), MOVEIT):
            _wrapped(called(call), path, collector)


def _default_files(call: ast.Call, directory: str, values: Values, collector: Collector) -> None:
    """Report problems of the files that the builder reads without being told."""
    text = values.source.data
    if _PLANNER.search(text) or not _NO_PLANNER.search(text):
        _without_plugin(directory, collector)
    methods = _methods(call)
    for method, (file, _) in data("moveit")["wrapped"].items():
        if method not in methods:
            _wrapped(method, os.path.join(directory, "config", file), collector)


def _required_files(
    call: ast.Call, builder: ast.Call, directory: str, values: Values, collector: Collector
) -> None:
    """Record the files that the builder reads by default, and that it cannot do without."""
    methods = _methods(call)
    robot = values.text(argument(builder, 0, "robot_name"))
    needed = [
        data("moveit")["wrapped"][method][0]
        for method in ("robot_description_kinematics", "joint_limits")
        if method not in methods
    ]
    has_pilz = _has_pilz(methods.get("planning_pipelines"), values)
    if has_pilz and "pilz_cartesian_limits" not in methods:
        needed.append(data("moveit")["wrapped"]["pilz_cartesian_limits"][0])
    has_assistant = disk.exists(os.path.join(directory, ".setup_assistant"))
    if robot and not has_assistant and "robot_description_semantic" not in methods:
        needed.append(f"{robot}.srdf")
    paths = [os.path.join(directory, "config", file) for file in needed]
    missing = [os.path.basename(path) for path in paths if not disk.exists(path)]
    if missing:
        package = os.path.basename(directory)
        message = f"the builder reads files that {package}/config does not have: "
        help = "create them, or name others in the methods of the builder"
        problem = Problem("LAU003", values.span(builder), message + ", ".join(missing), help)
        collector.problems.append(problem)
    execution = methods.get("trajectory_execution")
    if execution is None or not (execution.args or argument(execution, None, "file_path")):
        at = values.span(builder)
        collector.problems += _several_controllers(robot, os.path.join(directory, "config"), at)


def _has_pilz(call: ast.Call | None, values: Values) -> bool:
    """True if the pipeline of Pilz is loaded, as it is by default."""
    if call is None:
        return True
    load_all, pipelines = argument(call, 2, "load_all"), argument(call, 1, "pipelines")
    if pipelines is None:
        return load_all is None
    return _PILZ in [values.text(item) for item in values.items(pipelines)]


def _several_controllers(robot: str | None, directory: str, at: Span) -> Iterator[Problem]:
    """Files of controllers among which the builder cannot choose."""
    files = disk.names(directory) if disk.is_directory(directory) else []
    found = sorted(file for file in files if file.endswith(_CONTROLLERS))
    preferred = {f"{name}{_CONTROLLERS}" for name in ("moveit", "moveit2", robot)}
    if robot and len(found) > 1 and preferred.isdisjoint(found):
        message = "the builder cannot choose between " + ", ".join(found)
        help = 'write .trajectory_execution(file_path="config/...")'
        yield Problem("LAU024", at, message, help)


def _named_pipelines(call: ast.Call, directory: str, values: Values, collector: Collector) -> None:
    """Report pipelines without settings."""
    for item in values.items(argument(call, 1, "pipelines")):
        name = values.text(item)
        file = os.path.join(directory, "config", f"{name}_planning.yaml")
        if item is not None and name and name not in _PIPELINES and not disk.exists(file):
            message = f"planning pipeline '{name}' has no config/{name}_planning.yaml"
            message += did_you_mean(name, _PIPELINES)
            help = "add the file, or name one of " + ", ".join(_PIPELINES)
            collector.problems.append(Problem("LAU003", values.span(item), message, help))


def _default(call: ast.Call, values: Values, collector: Collector) -> None:
    """Report a default that is not one of the pipelines, which the builder rejects."""
    node = argument(call, 0, "default_planning_pipeline")
    names = [values.text(item) for item in values.items(argument(call, 1, "pipelines"))]
    known = [name for name in names if name]
    default = values.text(node)
    if node is not None and default and known and default not in names and None not in names:
        message = f"default_planning_pipeline '{default}' is not in pipelines: {', '.join(known)}"
        help = f"add '{default}' to pipelines"
        collector.problems.append(Problem("LAU024", values.span(node), message, help))


def _without_plugin(directory: str, collector: Collector) -> None:
    """Report pipelines of a package whose settings have no planning plugin."""
    for name in _PIPELINES:
        path = os.path.join(directory, "config", f"{name}_planning.yaml")
        try:
            root = mapping(load(collector.resolver.read(path))) if disk.is_file(path) else {}
        except UnreadableFile:
            continue
        if any(isinstance(key, Key) for key in root) and root.keys().isdisjoint(
            ("planning_plugin", "planning_plugins")
        ):
            message = f"config/{name}_planning.yaml has no planning plugin"
            help = f"add planning_plugins (planning_plugin up to Humble) with the plugin of {name}"
            if mapping(root, name):
                message += f": its settings are below '{name}'"
                help = f"remove '{name}:', and the indentation below it"
            first = next(key for key in root if isinstance(key, Key))
            problem = Problem("LAU024", first.span, message, help, severity=Severity.WARNING)
            collector.problems.append(problem)


def _wrapped(method: str, path: str, collector: Collector) -> None:
    """Report a file with names around its contents that the builder adds, or does not read."""
    _, prefix = data("moveit")["wrapped"].get(method, ("", ""))
    source = collector.resolver.readable(path) if disk.is_file(path) else None
    file = os.path.basename(path)
    for key, value in mapping(load(source)).items() if source else ():
        inner = mapping(value)
        if not isinstance(key, Key) or not inner:
            continue
        extra = [str(key)]
        message = f"{file}: MoveItConfigsBuilder adds {prefix} around the file, which has it"
        if _SECTION in inner:
            message = f"{file}: MoveItConfigsBuilder reads the file as it is, without {_SECTION}"
            extra = [key, _SECTION, *(name for name in mapping(inner, _SECTION) if name == prefix)]
        elif key != prefix:
            continue
        names = ", ".join(f"'{name}:'" for name in extra)
        help = f"remove {names}, and the indentation of what is below"
        problem = Problem("LAU024", key.span, message, help, severity=Severity.WARNING)
        if problem not in collector.problems:
            collector.problems.append(problem)


def _describe(call: ast.Call, directory: str, values: Values, collector: Collector) -> None:
    """Record the robot of the builder with the arguments of its ``mappings``."""
    path = values.text(argument(call, 0, "file_path")) or ""
    path = os.path.normpath(os.path.join(directory, path))
    given = argument(call, 1, "mappings")
    if not path.endswith(".xacro") or given is None or not disk.is_file(path):
        return
    pairs = [(values.text(key), values.text(value)) for key, value in values.pairs(given)]
    known = {name: value for name, value in pairs if name and value is not None}
    unknown = tuple(name or "" for name, value in pairs if not name or value is None)
    if pairs and "" not in unknown:
        span = values.span(call)
        frame = frame_at(values.source, Tag(values.source, span.start, span.start), None)
        collector.configured.append(LaunchedDescription(path, known, frame, unknown))


def _methods(call: ast.Call) -> dict[str, ast.Call]:
    """The methods in a chain of calls, by name."""
    methods: dict[str, ast.Call] = {}
    node: ast.expr = call
    while isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        methods[node.func.attr] = node
        node = node.func.value
    return methods


def _builder(call: ast.Call) -> ast.Call | None:
    """The call that begins a chain of methods, if it creates a builder."""
    node: ast.expr = call
    while isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        node = node.func.value
    is_builder = isinstance(node, ast.Call) and called(node) == "MoveItConfigsBuilder"
    return node if isinstance(node, ast.Call) and is_builder and node is not call else None


def is_configuration(node: ast.expr | None, values: Values) -> bool:
    """True for parameters that ``MoveItConfigsBuilder`` made: all, or an attribute."""
    node = values.resolved(node)
    if isinstance(node, ast.Call) and called(node) == "to_dict":
        node = node.func
    made = values.resolved(node.value) if isinstance(node, ast.Attribute) else None
    return isinstance(made, ast.Call) and _builder(made) is not None


def parameter_problems(
    node: ast.Call, tree: ast.Module, values: Values, collector: Collector
) -> Iterator[Problem]:
    """Missing parameters of a ``Node`` with move_group; empty unless all parameters are known."""
    if _CHANGES.search(values.source.data):
        return
    reader = _Reader(tree, values, collector)
    parameters = argument(node, None, "parameters")
    items = values.items(parameters) if parameters else [None]
    keys = {key for item in items for key in reader.keys(item)}
    if _OPEN in keys:
        return
    if _DESCRIPTION in keys and _SEMANTIC not in keys:
        message = f"move_group gets no {_SEMANTIC}, and so no planning groups"
        help = f'add {{"{_SEMANTIC}": ...}} with the text of the SRDF'
        yield Problem("LAU024", values.span(node), message, help, severity=Severity.WARNING)
    for item in items:
        for name, place in reader.pipelines(item):
            plugins = (_OPEN, "planning_plugin", "planning_plugins")
            if not keys.isdisjoint(f"{name}.{plugin}" for plugin in plugins):
                continue
            message = f"planning pipeline '{name}' has no planning plugin"
            help = f'add "{name}" with planning_plugins, as in {name}_planning.yaml'
            yield Problem("LAU024", values.span(place), message, help, severity=Severity.WARNING)
    if any(key.endswith(_SOLVER) and key.count(".") == 1 for key in keys):
        message = (
            f"the kinematics solvers are not in {_KINEMATICS}: from ROS 2 Iron on, no planning "
            "group has a solver"
        )
        help = f'write {{"{_KINEMATICS}": ...}} around them'
        # MoveIt of Humble, for which a launch file may be, reads them there as well.
        yield Problem("LAU024", values.span(node), message, help, severity=Severity.INFO)


def without_kinematics(
    node: ast.Call, tree: ast.Module, values: Values, collector: Collector
) -> Iterator[Problem]:
    """An RViz that gets the planning groups and not their solvers."""
    words = [values.text(word) or "" for word in values.items(argument(node, None, "arguments"))]
    file = next((word for word in words if word.endswith(".rviz")), "")
    configuration = collector.resolver.readable(file) if os.path.isabs(file) else None
    is_planner = configuration is not None and _DISPLAY in configuration.data
    if not is_planner or _CHANGES.search(values.source.data):
        return
    reader = _Reader(tree, values, collector)
    parameters = argument(node, None, "parameters")
    names: set[str] = set()
    for item in values.items(parameters) if parameters else ():
        part = values.resolved(item)
        names |= {part.attr} if isinstance(part, ast.Attribute) else reader.keys(item)
    if _OPEN not in names and _SEMANTIC in names and _KINEMATICS not in names:
        message = f"RViz has {_SEMANTIC}, but not {_KINEMATICS}: its MotionPlanning has no markers"
        help = f"add {_KINEMATICS} to its parameters"
        yield Problem("LAU024", values.span(node), message, help, severity=Severity.WARNING)


class _Reader:
    """Reads names in dictionaries, and in YAML files that a function of the launch file loads."""

    def __init__(self, tree: ast.Module, values: Values, collector: Collector) -> None:
        self._values = values
        self._resolver = collector.resolver
        self._functions = {
            node.name
            for node in tree.body
            if isinstance(node, ast.FunctionDef)
            and any(isinstance(n, ast.Call) and called(n) in _LOADS for n in ast.walk(node))
        }

    def keys(self, node: ast.expr | None) -> set[str]:
        """The names of parameters, with dots between levels."""
        node = self._values.resolved(node)
        if isinstance(node, ast.Dict):
            names: set[str] = set()
            for key, value in self._values.pairs(node):
                name = self._values.text(key)
                if name is None:
                    return {_OPEN}
                names |= {name, *(f"{name}.{inner}" for inner in self.keys(value))}
            return names
        root = self._loaded(node) if isinstance(node, ast.Call) else None
        if root is None:
            return {_OPEN}
        nested = {f"{key}.{inner}" for key, value in root.items() for inner in mapping(value)}
        return {*map(str, root), *nested}

    def pipelines(self, node: ast.expr | None) -> Iterator[tuple[str, ast.expr]]:
        """The names in a list of planning pipelines, with their locations."""
        for key, value in self._values.pairs(node):
            is_pipelines = self._values.text(key) == "planning_pipelines"
            for item in self._values.items(value) if is_pipelines else ():
                if item is not None and (name := self._values.text(item)):
                    yield name, item

    def _loaded(self, call: ast.Call) -> dict[str, Node] | None:
        """The YAML that a function of the launch file reads from a path, or a path in a package."""
        texts = [self._values.text(argument) for argument in call.args]
        if called(call) not in self._functions or call.keywords or None in texts:
            return None
        parts = [text or "" for text in texts]
        try:
            if len(parts) == 2:
                parts[0] = self._resolver.package(parts[0], self._values.source.path)
            path = os.path.join(*parts) if parts else ""
            if not os.path.isabs(path) or not disk.is_file(path):
                return None
            return mapping(load(self._resolver.read(path)))
        except UrdfkitError:
            return None

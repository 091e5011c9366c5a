"""``MoveItConfigsBuilder`` in Python launch files: the files that it reads.

Source: ``moveit_configs_builder.py`` of moveit_configs_utils.
"""

import ast
import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.suggest import CLOSE_TYPO, did_you_mean, nearest
from urdfkit.errors import PackageNotFound, UnreadableFile
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.calls import argument, called
from urdfkit.ros.launch.collect import UNKNOWN, Collector, frame_at
from urdfkit.ros.launch.contents import MOVEIT, PARAMETERS, FileUse, LaunchedDescription
from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import Tag
from urdfkit.text.located_yaml import items, load, mapping
from urdfkit.text.source import Span
from urdfkit.workspace.srdf_files import setup_assistant

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
_SECTION = "ros__parameters"
#: Launches of moveit_configs_utils that need no planner.
_NO_PLANNER = re.compile(
    rb"\bgenerate_(moveit_rviz|rsp|setup_assistant|spawn_controllers|static_virtual_joint_tfs"
    rb"|warehouse_db)_launch\("
)
#: Those that need one, and what is passed on to other programs.
_PLANNER = re.compile(
    rb"\bgenerate_(demo|move_group)_launch\(|\.(to_dict\(|planning_pipelines\b(?!\s*\())"
)
#: Starts ros2_control with config/ros2_controllers.yaml.
_DEMO = re.compile(rb"\bgenerate_demo_launch\(")
#: Starts ros2_control with the parameter files of the launch file.
_MANAGER = b"ros2_control_node"

#: Import of a builder of another package, which has methods and files of its own.
_OTHER = re.compile(
    rb"^[ \t]*from[ \t]+(?!moveit_configs_utils\b)\S+[ \t]+import\b[^\n(]*"
    rb"(?:\([^()]*)?\bMoveItConfigsBuilder\b",
    re.MULTILINE,
)


def record_files(call: ast.Call, values: Values, collector: Collector) -> None:
    """Record the files that a method of the builder reads, and its package."""
    builder = _builder(call)
    if builder is None or _OTHER.search(values.source.data):
        return
    collector.problems += _unknown_names(call, values)
    robot = values.text(argument(builder, 0, "robot_name"))
    package = values.package_of(builder)
    if not package:
        return
    written = argument(builder, 1, "package_name")
    directory = collector.package(package, values.source, values.span(written or builder))
    if called(call) == "robot_description":
        _describe(call, directory or "", values, collector)
    if called(call) in _FILES:
        _given_file(call, directory or f"{UNKNOWN}/{package}", values, collector)
    elif called(call) == "to_moveit_configs" and directory:
        _default_files(call, directory, values, collector)
        _required_files(call, builder, directory, values, collector)
        _robot_and_controllers(call, robot, directory, values, collector)
        collector.problems += _different_prefixes(_methods(call), values)
    elif called(call) == "planning_pipelines" and directory:
        _default(call, values, collector)
        _named_pipelines(call, directory, values, collector)


def _unknown_names(call: ast.Call, values: Values) -> Iterator[Problem]:
    """A method that the builder does not have, and keywords that a method does not have."""
    methods: dict[str, str] = data("moveit")["builder"]
    name = called(call)
    known = methods.get(name)
    if known is None and (suggested := nearest(name, filter(None, methods), CLOSE_TYPO)):
        message = f"MoveItConfigsBuilder has no method '{name}'; did you mean '{suggested}'?"
        yield values.problem("LAU033", call, message, f"write {suggested}")
    for keyword in call.keywords if known is not None else ():
        if keyword.arg and keyword.arg not in (names := (known or "").split()):
            message = f"{name} of MoveItConfigsBuilder has no argument '{keyword.arg}'"
            help = "remove it" if not names else f"known arguments: {', '.join(names)}"
            yield values.problem(
                "LAU033", keyword.value, message + did_you_mean(keyword.arg, names), help
            )


def unknown_attribute(node: ast.expr | None, values: Values) -> Iterator[Problem]:
    """An attribute that the configuration of a builder does not have, or the builder itself."""
    if isinstance(node, ast.Call) and called(node) == "to_dict" and is_configuration(node, values):
        made = values.resolved(node.func.value if isinstance(node.func, ast.Attribute) else None)
        if isinstance(made, ast.Call) and "to_moveit_configs" not in _methods(made):
            message = "MoveItConfigsBuilder has no 'to_dict', unlike what it builds"
            yield values.problem("LAU033", node, message, "call .to_moveit_configs() before")
    known = data("moveit")["builder"][""].split()
    is_other = _OTHER.search(values.source.data)
    if isinstance(node, ast.Attribute) and is_configuration(node, values) and not is_other:
        made = values.resolved(node.value)
        if called(made) == "to_moveit_configs" and node.attr not in known:
            message = f"the configuration of MoveIt has no '{node.attr}'"
            message += did_you_mean(node.attr, known)
            yield values.problem("LAU033", node, message, f"name one of: {', '.join(known)}")


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
    config = os.path.join(directory, "config")
    if "robot_description_semantic" not in methods:
        named = setup_assistant(directory).srdf
        needed += [os.path.relpath(named, "config")] if named else [f"{robot}.srdf"] * bool(robot)
    missing = [file for file in needed if not disk.exists(os.path.join(config, file))]
    if missing:
        package = os.path.basename(directory)
        message = f"the builder reads files that {package}/config does not have: "
        help = "create them, or name others in the methods of the builder"
        problem = Problem("LAU003", values.span(builder), message + ", ".join(missing), help)
        collector.problems.append(problem)
    execution = methods.get("trajectory_execution")
    if execution is None or not (execution.args or argument(execution, None, "file_path")):
        at = values.span(builder)
        collector.problems += _several_controllers(robot, config, at)


def _different_prefixes(methods: dict[str, ast.Call], values: Values) -> Iterator[Problem]:
    """A prefix of names that the SRDF gets with another value than the robot."""
    calls = methods.get("robot_description"), methods.get("robot_description_semantic")
    of_robot, of_srdf = (
        {
            values.text(key): value
            for key, value in values.pairs(argument(call, 1, "mappings") if call else None)
        }
        for call in calls
    )
    for name in of_srdf.keys() & of_robot.keys():
        given, expected = values.text(of_srdf[name]), values.text(of_robot[name])
        is_prefix = name is not None and name.rpartition("_")[2] == "prefix"
        if is_prefix and given is not None and expected is not None and given != expected:
            message = (
                f"the SRDF gets {name} '{given}', but the robot '{expected}': MoveIt does not "
            )
            message += "find the links and joints of its groups"
            help = f"pass the same {name} to both"
            yield values.problem("LAU029", of_srdf[name], message, help)


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
    files = disk.names_or_empty(directory)
    found = sorted(file for file in files if file.endswith(_CONTROLLERS))
    preferred = {f"{name}{_CONTROLLERS}" for name in ("moveit", "moveit2", robot)}
    if robot and len(found) > 1 and preferred.isdisjoint(found):
        message = "the builder cannot choose between " + ", ".join(found)
        help = 'write .trajectory_execution(file_path="config/...")'
        yield Problem("LAU029", at, message, help)


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
        collector.problems.append(Problem("LAU029", values.span(node), message, help))


def _without_plugin(directory: str, collector: Collector) -> None:
    """Report pipelines of a package whose settings have no planning plugin."""
    for name in _PIPELINES:
        path = os.path.join(directory, "config", f"{name}_planning.yaml")
        try:
            root = mapping(load(collector.resolver.read(path))) if disk.is_file(path) else {}
        except UnreadableFile:
            continue
        first = next((key for key, _ in items(root)), None)
        if first and root.keys().isdisjoint(("planning_plugin", "planning_plugins")):
            message = f"config/{name}_planning.yaml has no planning plugin"
            help = f"add planning_plugins (planning_plugin up to Humble) with the plugin of {name}"
            if mapping(root, name):
                message += f": its settings are below '{name}'"
                help = f"remove '{name}:', and the indentation below it"
            problem = Problem("LAU029", first.span, message, help, severity=Severity.WARNING)
            collector.problems.append(problem)


def _wrapped(method: str, path: str, collector: Collector) -> None:
    """Report a file with names around its contents that the builder adds, or does not read."""
    _, prefix = data("moveit")["wrapped"].get(method, ("", ""))
    source = collector.resolver.readable(path) if disk.is_file(path) else None
    file = os.path.basename(path)
    for key, value in items(load(source)) if source else ():
        inner = mapping(value)
        if not inner:
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
        problem = Problem("LAU029", key.span, message, help, severity=Severity.WARNING)
        if problem not in collector.problems:
            collector.problems.append(problem)


def _describe(call: ast.Call, directory: str, values: Values, collector: Collector) -> None:
    """Record the robot of the builder with the arguments of its ``mappings``."""
    robot = _described(call, directory, values)
    if robot and robot.path.endswith(".xacro") and values.pairs(argument(call, 1, "mappings")):
        collector.configured += [robot] if "" not in robot.unknown else []


def _described(call: ast.Call, directory: str, values: Values) -> LaunchedDescription | None:
    """The robot of a call of ``robot_description``; None if its file is not found."""
    path = values.text(argument(call, 0, "file_path")) or ""
    path = os.path.normpath(os.path.join(directory, path))
    given = argument(call, 1, "mappings")
    pairs = [(values.text(key), values.text(value)) for key, value in values.pairs(given)]
    known = {name: value for name, value in pairs if name and value is not None}
    unknown = tuple(name or "" for name, value in pairs if not name or value is None)
    if given is not None and not pairs:
        unknown = ("",)
    return _launched(path, call, values, known, unknown)


def _launched(
    path: str,
    call: ast.Call,
    values: Values,
    arguments: dict[str, str],
    unknown: tuple[str, ...] = (),
) -> LaunchedDescription | None:
    if not disk.is_file(path):
        return None
    span = values.span(call)
    frame = frame_at(values.source, Tag(values.source, span.start, span.start), None)
    return LaunchedDescription(path, arguments, frame, unknown)


def _robot_and_controllers(
    call: ast.Call, robot: str | None, directory: str, values: Values, collector: Collector
) -> None:
    """Record the robot and the controllers of a launch file that starts ros2_control.

    Those of a demo have fixed names. The robot alone if the setup assistant was given arguments
    for it: the builder passes them to xacro where it gets no mappings.
    """
    given = _methods(call).get("robot_description")
    assisted = setup_assistant(directory).arguments
    default = None
    if given is not None:
        built = _described(given, directory, values)
    else:
        default = _default_robot(robot, directory, values, collector)
        built = _launched(default, call, values, dict(assisted))
    controllers = os.path.join(directory, "config", "ros2_controllers.yaml")
    if built is None:
        return
    if _MANAGER in values.source.data:
        collector.built.append((built, None))
    elif default and _DEMO.search(values.source.data) and disk.is_file(controllers):
        file = FileUse(controllers, True, values.span(call), PARAMETERS)
        collector.built.append((built, file))
    elif default and assisted:
        collector.built.append((built, None))


def _default_robot(robot: str | None, directory: str, values: Values, collector: Collector) -> str:
    """The file of the robot that no method names: of the package, otherwise of the assistant."""
    own = os.path.join(directory, "config", f"{robot}.urdf.xacro") if robot else ""
    setup = setup_assistant(directory)
    if disk.is_file(own) or not setup.urdf:
        return own
    try:
        package = collector.resolver.package(setup.package, values.source.path)
    except PackageNotFound:
        return own
    return os.path.normpath(os.path.join(package, setup.urdf))


def _methods(call: ast.Call) -> dict[str, ast.Call]:
    """The methods in a chain of calls, by name."""
    methods: dict[str, ast.Call] = {}
    node: ast.expr = call
    while isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        methods[node.func.attr] = node
        node = node.func.value
    return methods


def is_configuration(node: ast.expr | None, values: Values) -> bool:
    """True for parameters that ``MoveItConfigsBuilder`` made: all, or an attribute."""
    node = values.resolved(node)
    if isinstance(node, ast.Call) and called(node) == "to_dict":
        node = node.func
    made = values.resolved(node.value) if isinstance(node, ast.Attribute) else None
    return isinstance(made, ast.Call) and _builder(made) is not None


def _builder(call: ast.Call) -> ast.Call | None:
    """The call that begins a chain of methods, if it creates a builder."""
    node: ast.expr = call
    while isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        node = node.func.value
    is_builder = called(node) == "MoveItConfigsBuilder"
    return node if isinstance(node, ast.Call) and is_builder and node is not call else None

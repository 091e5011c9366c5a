"""A parameter file of controllers does not exist, or a part of it is not read.

- The file that the Gazebo control plugin names does not exist. The controller manager stops, no
  controller can be loaded, and Gazebo may stop as well. The file has another name or directory, or
  is not installed. An absolute path outside the repository or workspace is a warning: it may exist
  on another machine, such as `/workspace/install/...` in a container. A path that depends on an
  argument or a property is an info; a warning if a launch file starts the robot with the default.
- A launch file of ROS 1 loads controllers that are below `ros__parameters`, as in ROS 2.
- The file is not YAML, `ros__parameters` is misspelt (two underscores), or parameters are below a
  name that no controller has. The controller then starts without its joints, and stops: "parameter
  'joints' was not set".
- The control plugin has a `<namespace>`, and the parameters of its controller manager are not below
  this namespace (warning): "The 'type' param was not defined for 'joint_state_broadcaster'".

Sources:
    gz_ros2_control_plugin.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_ros2_control_plugin.cpp
    gazebo_ros2_control_plugin.cpp: https://github.com/ros-controls/gazebo_ros2_control/blob/master/gazebo_ros2_control/src/gazebo_ros2_control_plugin.cpp
    ros-controls/ros2_control#1552: https://github.com/ros-controls/ros2_control/issues/1552
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
"""

import os
import re
from collections.abc import Iterator
from itertools import islice

from urdfkit.core.suggest import TYPO, hint_for, is_typo, nearest, nearest_file
from urdfkit.errors import PackageNotFound
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.ros.catalog.controllers import parameters_of
from urdfkit.ros.controllers import (
    MANAGER,
    ParameterFile,
    Section,
    parameter_files,
    read,
    readable_files,
)
from urdfkit.ros.gazebo.samples import ARM, CONTROL, controller_yaml
from urdfkit.ros.node_parameters import PARAMETERS, node_parameters
from urdfkit.ros.ros_control import control_plugins, namespace_of
from urdfkit.text.document import Element
from urdfkit.text.located_yaml import Key, Node, Value, items, load, mapping, scalar, syntax_error
from urdfkit.text.source import Span

BAD = ARM + CONTROL
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = controller_yaml("position_controllers/JointGroupPositionController", "joints: [shoulder]")
FILES = {
    "config/bad.yaml": _YAML.replace(b"arm:\n  ros__parameters", b"arm:\n  ros_parameters"),
    "config/good.yaml": _YAML,
}

#: A path in a package.
_IN_PACKAGE = r"\$\(find ([\w-]+)\)/([^$]+)"
#: Directories of generated files.
_GENERATED = ("generated", "temp", "tmp")


@rule(Severity.ERROR, help="fix the parameter file")
def check(context: Context) -> Findings:
    yield from _missing(context)
    for file, source in readable_files(context):
        if error := syntax_error(source, in_python=file.is_of_ros1):
            span, reason = error
            yield Finding(span, f"invalid YAML: {reason}", related=(file.note,))
        unread = _of_ros2 if file.is_of_ros1 else _unread_keys
        if file.element and (controllers := read(source)) and controllers[0].ros == 1:
            unread = _without_nodes
        for span, message, help in unread(load(source)):
            yield Finding(span, message, help, related=(file.note,))
    yield from _outside_namespace(context)


def _outside_namespace(context: Context) -> Findings:
    """Parameters of a controller manager that is in another namespace."""
    files = {file.path: file for file in parameter_files(context) if file.element}
    for plugin in control_plugins(context.model):
        element = namespace_of(plugin.at)
        namespace = element.text.strip().strip("/") if element else ""
        paths = [tag.text.strip() for tag in plugin.at.all("parameters")]
        named = [files[path] for path in paths if namespace and path in files]
        sources = (context.resolver.readable(file.found) for file in named if file.found)
        sections = [section for source in sources if source for section in node_parameters(source)]
        written = {f"{section.namespace}/{section.name}".strip("/") for section in sections}
        lost = next((section for section in sections if section.name == MANAGER), None)
        node = f"{namespace}/{MANAGER}"
        if element and lost and node not in written and not any("*" in name for name in written):
            yield Finding(
                lost.at,
                f"parameters of '{MANAGER}' are not read: the node is '/{node}'",
                f"write /{node}, or /**/{MANAGER}; the controllers need the namespace, too",
                related=(Related(element.span, "the namespace"), named[0].note),
                severity=Severity.WARNING,
            )


def _missing(context: Context) -> Findings:
    for file in parameter_files(context):
        if not file.element:
            continue  # LAU003 reports the files of launch files
        if "://" in file.path:
            message = f"the plugin reads '{file.path}' as a path, which does not exist"
            help = "write $(find PACKAGE)/config/FILE.yaml in the xacro, which works everywhere"
            yield Finding(file.element, message, help)
        # The launch file writes a generated file first.
        elif file.found is None and _directory(file.path) not in _GENERATED:
            yield _not_found(context, file, file.element)


def _directory(path: str) -> str:
    return os.path.basename(os.path.dirname(path))


def _not_found(context: Context, file: ParameterFile, element: Element) -> Finding:
    path = file.path
    is_here = context.resolver.packages.searches(path, context.source.path)
    suggested = nearest_file(path)
    hint = hint_for(suggested)
    where = "" if is_here else " on this machine"
    written = element.tag_at.inner_span.text
    has_find = "$(find " in written
    is_passed = path in context.arguments.values()  # by a launch file, or by the user
    is_chosen = "$" in re.sub(r"\$\(find [^)]*\)", "", written) and not is_passed
    severity = None if is_here else Severity.WARNING
    if is_chosen:
        is_default = is_here and _is_started_with_default(context, path)
        severity = Severity.WARNING if is_default else Severity.INFO
    package, relative = file.meant or ("PACKAGE", "config/FILE.yaml")
    write = f"write $(find {package})/{relative} in the xacro, which works everywhere"
    help = write if file.meant else f"correct the path; {write}"
    if has_find or is_passed:
        help = "correct the path"
    return Finding(
        element,
        f"parameter file not found{where}: {path}{hint}",
        help,
        severity=severity,
    )


def _is_started_with_default(context: Context, path: str) -> bool:
    """True if a launch file starts the robot with the default of an argument that is a path."""
    defaults = context.reading.defaults if context.is_launched else {}
    matches = {name: re.fullmatch(_IN_PACKAGE, value.strip()) for name, value in defaults.items()}
    for name, match in matches.items():
        if match is None or name in context.arguments:
            continue
        try:
            directory = context.resolver.package(match[1], context.source.path)
        except PackageNotFound:
            continue
        if os.path.normpath(f"{directory}/{match[2]}") == os.path.normpath(path):
            return True
    return False


def _of_ros2(root: Node) -> Iterator[tuple[Span, str, str]]:
    """Controllers in the form of ROS 2, which ROS 1 does not find: location, message and help."""
    for key, node in items(root):
        for inner, inside in items(node) if _node_of(key) == MANAGER else ():
            if inner == PARAMETERS and any(scalar(part, "type") for _, part in items(inside)):
                message = f"ROS 1 finds no controller below '{key}' and '{inner}', which are ROS 2"
                yield inner.span, message, "write the controllers at the top level of the file"


def _without_nodes(root: Node) -> Iterator[tuple[Span, str, str]]:
    """A file as of ROS 1 that a plugin of ROS 2 names: location, message and help."""
    for key, _ in islice(items(root), 1):
        message = f"ROS 2 rejects the file: nothing in it is below '{PARAMETERS}'"
        yield key.span, message, f"write '{MANAGER}: {PARAMETERS}: NAME: {{type: ...}}'"


def _unread_keys(root: Node) -> Iterator[tuple[Span, str, str]]:
    """The unread keys of a file: location, message and help."""
    sections = [(key, node) for key, node in items(root) if isinstance(node, dict)]
    for key, node in sections:
        for inner, _ in items(node):
            if inner != PARAMETERS and _is_parameters(inner):
                message = f"parameters of '{key}' are not read: '{inner}' is not '{PARAMETERS}'"
                yield inner.span, message, f"write {PARAMETERS}"
    declared: set[str] = set()
    yield from _misspelt_manager(sections)
    for key, node in sections:
        inside = node.get(PARAMETERS)
        if _node_of(key) == MANAGER and not any(map(_is_parameters, node)):
            message = f"ROS 2 rejects the file: nothing in '{key}' is below {PARAMETERS}"
            yield key.span, message, f"write {PARAMETERS}: below '{key}', and indent the rest"
        if _node_of(key) == MANAGER and isinstance(inside, dict):
            yield from _without_type(inside)
            yield from _below_manager(inside, dict(sections))
            section = Section({}, {}, None)
            section.add(inside)
            declared.update(section.types)
    yield from _unread_sections(sections, declared - {""})


def _unread_sections(
    sections: list[tuple[Key, dict[str, Node]]], declared: set[str]
) -> Iterator[tuple[Span, str, str]]:
    """Sections without a controller, and sections of controllers without ``ros__parameters``."""
    without = declared.difference(_node_of(key) for key, _ in sections)
    for key, node in sections:
        name = _node_of(key)
        if name in declared and not any(map(_is_parameters, node)):
            message = f"parameters of '{key}' are not read: they are not in {PARAMETERS}"
            yield key.span, message, f"write {PARAMETERS}: below '{key}', and indent the rest"
        elif name not in declared and (suggested := nearest(name, without, TYPO)):
            message = f"'{key}' is not a controller of the controller manager and not read"
            yield key.span, message, f"did you mean '{suggested}'?"


def _is_parameters(key: str) -> bool:
    return key == PARAMETERS or nearest(key, [PARAMETERS], TYPO) is not None


def _without_type(manager: dict[str, Node]) -> Iterator[tuple[Span, str, str]]:
    """A ``type`` without a controller, because of its indentation, or a misspelt ``type``."""
    kind = scalar(manager, "type")
    if kind and "/" in kind.text:
        message = "type without a controller: it is not indented below a name"
        yield kind.span, message, "indent it below the name of its controller"
    for name, node in manager.items():
        for key, value in items(node) if "type" not in mapping(node) else ():
            is_class = isinstance(value, Value) and "/" in value.text
            if is_class and is_typo(key, "type"):
                yield key.span, f"controller '{name}' has '{key}' instead of type", "write type"


def _misspelt_manager(
    sections: list[tuple[Key, dict[str, Node]]],
) -> Iterator[tuple[Span, str, str]]:
    """A section with the types of controllers whose name is that of the manager, misspelt."""
    for key, node in sections:
        inside = mapping(node, PARAMETERS)
        is_manager = any("type" in mapping(value) for value in inside.values())
        name = _node_of(key)
        if is_manager and name != MANAGER and is_typo(name, MANAGER):
            message = f"parameters of '{key}' are not read: the node is '{MANAGER}'"
            yield key.span, message, f"write {MANAGER}"


def _below_manager(
    manager: dict[str, Node], sections: dict[str, dict[str, Node]]
) -> Iterator[tuple[Span, str, str]]:
    """Parameters of a controller next to its type, where only the controller manager sees them.

    A controller that also has them in its own section works: those of ROS 1 were left over.
    """
    for name, node in manager.items():
        kind = scalar(node, "type")
        known = parameters_of(kind.text, 2) if kind else None
        own = mapping(sections.get(name), PARAMETERS)
        for key, _ in items(node) if known else ():
            is_own = known is not None and (known.type_of(key) or key in known.required)
            if is_own and key not in own:
                message = f"'{key}' of controller '{name}' is not read: it is a parameter of "
                message += MANAGER
                help = f"write it below {name}: {PARAMETERS}:, at the top level"
                yield key.span, message, help
                break


def _node_of(key: str) -> str:
    """Name of the node in a key such as ``/**/drive``."""
    return key.strip("/").rpartition("/")[2]

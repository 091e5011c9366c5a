"""The controllers of ros2_control in a YAML file, with the locations of all values.

The file is referenced in ``<parameters>`` of a control plugin, or loaded by the launch file that
starts the robot. In ROS 2, the parameters of each node are below ``ros__parameters``; in ROS 1,
controllers are in any namespace, and are identified by their ``type``.
Source: ``rcl_yaml_param_parser`` of ros2/rcl, ``controller_manager`` of ros_control.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby
from operator import itemgetter

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.suggest import TYPO, is_typo, nearest
from urdfkit.errors import UrdfkitError
from urdfkit.ros import RosDescription
from urdfkit.ros.catalog.controllers import parameters_of
from urdfkit.ros.catalog.ros_control import ControllerType, controller_types, simulated_hardware
from urdfkit.ros.ros_control import components, control_plugins
from urdfkit.text.diagnostic import Related
from urdfkit.text.document import Element
from urdfkit.text.grammar import is_expression
from urdfkit.text.located_yaml import Key, Node, Value, load, mapping, scalars, syntax_error
from urdfkit.text.source import Source, Span

_MANAGER = "controller_manager"
_PARAMETERS = "ros__parameters"


class Section(Record):
    """The parameters of a node."""

    #: Parameters by name, with dots between levels: a single value, or a list.
    given: dict[str, Value | list[Node]]
    places: dict[str, Span]  # locations of the names
    at: Span | None  # start of the section; None if the file has no parameters for the node

    def add(self, node: dict[str, Node]) -> None:
        stack: list[tuple[str, dict[str, Node]]] = [("", node)]
        while stack:
            above, mapping = stack.pop()
            for key, value in mapping.items():
                if not isinstance(key, Key):  # a list or mapping as key is not a parameter name
                    continue
                name = above + key
                self.places[name] = key.span
                if isinstance(value, dict):
                    stack.append((f"{name}.", value))
                elif value is not None:
                    self.given[name] = value

    def values(self, name: str) -> list[Value]:
        """The values of a parameter; a single value is a list of one item."""
        node = self.given.get(name, [])
        return scalars(node if isinstance(node, list) else [node])

    @property
    def types(self) -> dict[str, Value]:
        """Values of the parameters named ``type``, by the preceding part of their names."""
        names = (name for name in self.given if name == "type" or name.endswith(".type"))
        return {name[: -len(".type")]: self.values(name)[0] for name in names if self.values(name)}


class Controller(Record):
    """A controller with a type."""

    name: str  # of its node
    type: str  # class that the controller manager loads
    type_at: Span  # location of the type
    ros: int  # 1 or 2
    section: Section  # parameters as written

    @property
    def is_typed_by_itself(self) -> bool:
        """True if its type is in its own section, where only a spawner with the file reads it."""
        own = self.section.values("type") if self.ros == 2 else []
        return bool(own) and own[0].span == self.type_at

    @property
    def kind(self) -> ControllerType | None:
        """Catalogue entry of its type; None if the type is unknown."""
        return controller_types().get(self.type)

    def values(self, names: Iterable[str]) -> list[Value]:
        """The values of several parameters, concatenated."""
        return [value for name in names for value in self.section.values(name)]


class ParameterFile(Record):
    """A parameter file."""

    span: Span  # location of the reference in a control plugin or launch file
    path: str  # after expansion; absolute
    found: str | None  # the existing file, or None
    #: The ``<parameters>`` of the plugin; None for a reference in the launch file.
    element: Element | None = None

    @property
    def note(self) -> Related:
        """A note for findings in the file."""
        return Related(self.span, "the file is named here")


def parameter_files(description: RosDescription) -> list[ParameterFile]:
    """Files of the launch file, and files that control plugins reference by an absolute path."""
    files = {
        use.path: ParameterFile(use.span, use.path, use.path)
        for use in description.parameters
        if disk.is_file(use.path)
    }
    for plugin in () if _runs_on_hardware(description) else control_plugins(description.model):
        for element in plugin.at.all("parameters"):
            path = element.text.strip()
            if _is_address(path):
                files.setdefault(path, ParameterFile(element.span, path, None, element))
            if not path.startswith("/") or is_expression(path) or "\0" in path:
                continue
            found = path if disk.is_file(path) else description.resolver.installed(path)
            files.setdefault(path, ParameterFile(element.span, path, found, element))
    return list(files.values())


def _is_address(path: str) -> bool:
    """True for URIs such as ``package://...``, which control plugins do not resolve."""
    return path.startswith(("package://", "model://", "file://")) and not is_expression(path)


def _runs_on_hardware(description: RosDescription) -> bool:
    """True if a launch file starts the robot on hardware that is not simulated.

    Gazebo then does not run the control plugin of the description, and its controllers may
    belong to another variant of the robot.
    """
    hardware = [component.hardware for component in components(description.model)]
    is_real = bool(hardware) and simulated_hardware().keys().isdisjoint(hardware)
    return bool(description.parameters) and is_real


def controllers(description: RosDescription) -> Iterator[tuple[ParameterFile, Controller]]:
    """The controllers of the readable parameter files."""
    for file, source in _sources(description):
        for controller in read(source):
            yield file, controller


def by_file(
    found: Iterable[tuple[ParameterFile, Controller]],
) -> Iterator[tuple[ParameterFile, list[Controller]]]:
    """The controllers, grouped by file."""
    for file, several in groupby(found, key=itemgetter(0)):
        yield file, [controller for _, controller in several]


def _sources(description: RosDescription) -> Iterator[tuple[ParameterFile, Source]]:
    for file in parameter_files(description):
        if file.found and description.resolver.allows(file.found, description.source.path):
            try:
                source = description.resolver.read(file.found)
            except UrdfkitError:
                continue
            yield file, source


def read(source: Source) -> list[Controller]:
    """The controllers of a file; empty if it is not a YAML file of parameters."""
    root = load(source)
    sections = _sections(root)
    if not sections:
        return list(_of_ros1(root))
    types: dict[tuple[str, ...], Value] = {}
    # The controller manager reads the type from its own parameters.
    for path, section in sorted(sections.items(), key=lambda item: item[0][-1] == _MANAGER):
        for owner, kind in section.types.items():
            node = (*path[:-1], owner) if path[-1] == _MANAGER else path
            if bool(owner) is (path[-1] == _MANAGER):
                types[node] = kind
    return [
        Controller(path[-1], kind.text, kind.span, 2, sections.get(path, Section({}, {}, None)))
        for path, kind in types.items()
    ]


def managers(description: RosDescription) -> Iterator[tuple[ParameterFile, Section]]:
    """The parameters of the controller managers in ROS 2."""
    for file, source in _sources(description):
        for path, section in _sections(load(source)).items():
            if path[-1] == _MANAGER:
                yield file, section


def named_sections(description: RosDescription) -> dict[str, Section]:
    """The parameters of each node in ROS 2, from all files."""
    sections: dict[str, Section] = {}
    for _, source in _sources(description):
        for path, section in _sections(load(source)).items():
            whole = sections.setdefault(path[-1], Section({}, {}, section.at))
            whole.given.update(section.given)
            whole.places.update(section.places)
    return sections


def _sections(root: Node) -> dict[tuple[str, ...], Section]:
    """The parameters of each ROS node, by namespace and name; empty for ROS 1.

    ``**`` is any namespace.
    """
    sections: dict[tuple[str, ...], Section] = {}
    stack: list[tuple[tuple[str, ...], Node, str]] = [((), root, "")]
    while stack:
        path, node, above = stack.pop()
        for key, inner in mapping(node).items():
            if key == _PARAMETERS and path and isinstance(inner, dict):
                start = getattr(above, "span", None)
                sections.setdefault(path, Section({}, {}, start)).add(inner)
            elif key != _PARAMETERS:
                parts = [part for part in key.split("/") if part not in ("", "*", "**")]
                stack.append(((*path, *parts), inner, key))
    return sections


def _of_ros1(root: Node) -> Iterator[Controller]:
    """Mappings with a ``type`` that has a slash, in any namespace, and without a ``name``."""
    stack: list[tuple[str, Node]] = [("", root)]
    while stack:
        name, node = stack.pop()
        node = mapping(node)
        kind = node.get("type")
        if isinstance(kind, Value) and "/" in kind.text:
            at = name.span if isinstance(name, Key) else kind.span
            section = Section({}, {}, at)
            section.add(node)
            yield Controller(name, kind.text, kind.span, 1, section)
        elif not isinstance(node.get("name"), Value):
            # With a name it is a record from which a program creates an object.
            stack += node.items()


def syntax_errors(description: RosDescription) -> Iterator[tuple[ParameterFile, Span, str]]:
    """Parameter files that are not valid YAML, with the location and the reason."""
    for file, source in _sources(description):
        if error := syntax_error(source):
            yield file, *error


def unread_keys(
    description: RosDescription,
) -> Iterator[tuple[ParameterFile, list[tuple[Span, str, str]]]]:
    """Unread keys of each file: location, message and help."""
    for file, source in _sources(description):
        yield file, list(_unread_keys(load(source)))


def _unread_keys(root: Node) -> Iterator[tuple[Span, str, str]]:
    sections = [(k, node) for k, node in mapping(root).items() if isinstance(node, dict)]
    for key, node in sections:
        for inner in node:
            if isinstance(inner, Key) and inner != _PARAMETERS and _is_parameters(inner):
                message = f"parameters of '{key}' are not read: '{inner}' is not '{_PARAMETERS}'"
                yield inner.span, message, f"write {_PARAMETERS}"
    declared: set[str] = set()
    yield from _misspelt_manager(sections)
    for key, node in sections:
        inside = node.get(_PARAMETERS)
        if _node_of(key) == _MANAGER and isinstance(inside, dict):
            yield from _without_type(inside)
            yield from _below_manager(inside, dict(sections))
            section = Section({}, {}, None)
            section.add(inside)
            declared.update(section.types)
    yield from _unread_sections(sections, declared - {""})


def _unread_sections(
    sections: list[tuple[str, dict[str, Node]]], declared: set[str]
) -> Iterator[tuple[Span, str, str]]:
    """Sections without a controller, and sections of controllers without ``ros__parameters``."""
    without = declared.difference(_node_of(key) for key, _ in sections)
    for key, node in sections:
        name = _node_of(key)
        if not isinstance(key, Key):
            continue
        if name in declared and not any(map(_is_parameters, node)):
            message = f"parameters of '{key}' are not read: they are not in {_PARAMETERS}"
            yield key.span, message, f"write {_PARAMETERS}: below '{key}', and indent the rest"
        elif name not in declared and (suggested := nearest(name, without, TYPO)):
            message = f"'{key}' is not a controller of the controller manager and not read"
            yield key.span, message, f"did you mean '{suggested}'?"


def _is_parameters(key: str) -> bool:
    return key == _PARAMETERS or nearest(key, [_PARAMETERS], TYPO) is not None


def _without_type(manager: dict[str, Node]) -> Iterator[tuple[Span, str, str]]:
    """A ``type`` without a controller, because of its indentation, or a misspelt ``type``."""
    kind = manager.get("type")
    if isinstance(kind, Value) and "/" in kind.text:
        message = "type without a controller: it is not indented below a name"
        yield kind.span, message, "indent it below the name of its controller"
    for name, node in manager.items():
        for key, value in mapping(node).items() if "type" not in mapping(node) else ():
            is_class = isinstance(value, Value) and "/" in value.text
            if isinstance(key, Key) and is_class and is_typo(key, "type"):
                yield key.span, f"controller '{name}' has '{key}' instead of type", "write type"


def _misspelt_manager(
    sections: list[tuple[str, dict[str, Node]]],
) -> Iterator[tuple[Span, str, str]]:
    """A section with the types of controllers whose name is that of the manager, misspelt."""
    for key, node in sections:
        inside = mapping(node, _PARAMETERS)
        is_manager = any("type" in mapping(value) for value in inside.values())
        name = _node_of(key)
        if isinstance(key, Key) and is_manager and name != _MANAGER and is_typo(name, _MANAGER):
            message = f"parameters of '{key}' are not read: the node is '{_MANAGER}'"
            yield key.span, message, f"write {_MANAGER}"


def _below_manager(
    manager: dict[str, Node], sections: dict[str, dict[str, Node]]
) -> Iterator[tuple[Span, str, str]]:
    """Parameters of a controller next to its type, where only the controller manager sees them.

    A controller that also has them in its own section works: those of ROS 1 were left over.
    """
    for name, node in manager.items():
        kind = mapping(node).get("type")
        known = parameters_of(kind.text, 2) if isinstance(kind, Value) else None
        own = mapping(sections.get(name), _PARAMETERS)
        for key in mapping(node) if known else ():
            is_own = known is not None and (known.type_of(key) or key in known.required)
            if is_own and key not in own and isinstance(key, Key):
                message = f"'{key}' of controller '{name}' is not read: it is a parameter of "
                message += _MANAGER
                help = f"write it below {name}: {_PARAMETERS}:, at the top level"
                yield key.span, message, help
                break


def _node_of(key: str) -> str:
    """Name of the node in a key such as ``/**/drive``."""
    return key.strip("/").rpartition("/")[2]

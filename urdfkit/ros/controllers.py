"""The controllers of ros2_control in a YAML file, with the locations of all values.

The file is referenced in ``<parameters>`` of a control plugin, or loaded by the launch file that
starts the robot. In ROS 2, the parameters of each node are below ``ros__parameters``; in ROS 1,
controllers are in any namespace, and are identified by their ``type``.
Source: ``rcl_yaml_param_parser`` of ros2/rcl, ``controller_manager`` of ros_control.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import groupby
from operator import itemgetter

from urdfkit.core import disk
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.errors import PackageNotFound
from urdfkit.ros import RosDescription
from urdfkit.ros.catalog.ros_control import ControllerType, controller_types
from urdfkit.ros.node_parameters import PARAMETERS, node_parameters
from urdfkit.ros.ros_control import control_plugins, has_no_simulated_hardware
from urdfkit.text.diagnostic import Related
from urdfkit.text.document import Element
from urdfkit.text.grammar import is_expression
from urdfkit.text.located_yaml import Key, Node, Value, items, load, mapping, scalar, scalars
from urdfkit.text.source import Source, Span
from urdfkit.text.source_cache import cached_by_source

MANAGER = "controller_manager"


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
            for key, value in items(mapping):
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
        owners = {name[: -len(".type")]: self.values(name) for name in names}
        # Below a second ``ros__parameters`` it belongs to no controller.
        return {
            owner: values[0]
            for owner, values in owners.items()
            if values and not owner.endswith(f".{PARAMETERS}")
        }


class Controller(Record):
    """A controller with a type."""

    name: str  # of its node; empty if only the launch file names it, in ROS 1
    type: str  # class that the controller manager loads
    type_at: Span  # location of the type
    ros: int  # 1 or 2
    section: Section  # parameters as written
    namespaces: int = 0  # in ROS 1, the number of keys above its own

    @property
    def title(self) -> str:
        """Designation in messages."""
        return f"controller '{self.name}'" if self.name else "the controller"

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
    #: For a path of another computer: package and path in it of the file that it means here.
    meant: tuple[str, str] | None = None
    #: True if launch files of ROS 1 alone load it: there ``ros__parameters`` is a name like others.
    is_of_ros1: bool = False

    @property
    def note(self) -> Related:
        """A note for findings in the file."""
        return Related(self.span, "the file is named here")


def parameter_files(description: RosDescription) -> list[ParameterFile]:
    """Files of the launch file, and files that control plugins reference by an absolute path."""
    of_ros2 = {use.path for use in description.parameters if not use.is_of_ros1}
    files = {
        use.path: ParameterFile(use.span, use.path, use.path, is_of_ros1=use.path not in of_ros2)
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
            meant = None if found else _meant(path, description)
            files.setdefault(path, ParameterFile(element.span, path, found, element, meant))
    return list(files.values())


def _meant(path: str, description: RosDescription) -> tuple[str, str] | None:
    """The package of this workspace and the path in it that a path of another computer means.

    As in ``/home/me/ws/src/arm/config/controllers.yaml``; None if there is no such file.
    """
    parts = path.split("/")
    for number in range(1, len(parts) - 1):
        try:
            directory = description.resolver.package(parts[number], description.source.path)
        except PackageNotFound:
            continue
        relative = "/".join(parts[number + 1 :])
        # A directory is not enough: a workspace with its install/ has one, too.
        is_package = disk.is_file(os.path.join(directory, "package.xml"))
        if is_package and disk.is_file(os.path.join(directory, relative)):
            return parts[number], relative
    return None


def _is_address(path: str) -> bool:
    """True for URIs such as ``package://...``, which control plugins do not resolve."""
    return path.startswith(("package://", "model://", "file://")) and not is_expression(path)


def _runs_on_hardware(description: RosDescription) -> bool:
    """True if a launch file starts the robot on hardware that is not simulated.

    Gazebo then does not run the control plugin of the description, and its controllers may
    belong to another variant of the robot.
    """
    return bool(description.parameters) and has_no_simulated_hardware(description.model)


def controllers(description: RosDescription) -> Iterator[tuple[ParameterFile, Controller]]:
    """The controllers of the readable parameter files."""
    files = list(readable_files(description))
    of_ros2 = [source for file, source in files if not file.is_of_ros1]
    for file, source in files:
        for controller in with_parameters(read(source, is_of_ros1=file.is_of_ros1), of_ros2):
            if file.element is None or controller.ros == 2:  # RCT026 reports the others
                yield file, controller


def by_file(
    found: Iterable[tuple[ParameterFile, Controller]],
) -> Iterator[tuple[ParameterFile, list[Controller]]]:
    """The controllers, grouped by file."""
    for file, several in groupby(found, key=itemgetter(0)):
        yield file, [controller for _, controller in several]


def readable_files(description: RosDescription) -> Iterator[tuple[ParameterFile, Source]]:
    """The parameter files that can be read."""
    resolver, near = description.resolver, description.source.path
    for file in parameter_files(description):
        path = file.found
        if file.meant:
            package, relative = file.meant
            path = os.path.join(resolver.package(package, near), relative)
        allowed = path if path and resolver.allows(path, near) else None
        if allowed and (source := resolver.readable(allowed)):
            yield file, source


@lru_cache(maxsize=256)  # for each launch file of a workspace, all its files of parameters are read
def read(source: Source, *, is_of_ros1: bool = False) -> tuple[Controller, ...]:
    """The controllers of a file; empty if it is not a YAML file of parameters."""
    sections = {} if is_of_ros1 else _sections(source)
    if not sections:
        return tuple(_of_ros1(load(source)))
    types: dict[tuple[str, ...], Value] = {}
    # The controller manager reads the type from its own parameters.
    for path, section in sorted(sections.items(), key=lambda item: item[0][-1] == MANAGER):
        for owner, kind in section.types.items():
            node = (*path[:-1], owner) if path[-1] == MANAGER else path
            if bool(owner) is (path[-1] == MANAGER):
                types[node] = kind
    return tuple(
        Controller(path[-1], kind.text, kind.span, 2, sections.get(path, Section({}, {}, None)))
        for path, kind in types.items()
    )


def with_parameters(found: Iterable[Controller], sources: Iterable[Source]) -> Iterator[Controller]:
    """Controllers of ROS 2; their parameters may be in another file, which a spawner loads."""
    others: dict[str, list[Section]] | None = None
    for controller in found:
        if controller.ros == 1 or controller.section.at:
            yield controller
            continue
        if others is None:
            sections = (item for source in sources for item in _sections(source).items())
            others = by_key((path[-1], section) for path, section in sections)
        own = others.get(controller.name, [])
        yield controller._replace(section=own[0]) if len(own) == 1 else controller


def managers(description: RosDescription) -> Iterator[tuple[ParameterFile, Section]]:
    """The parameters of the controller managers in ROS 2."""
    for file, source in readable_files(description):
        for path, section in () if file.is_of_ros1 else _sections(source).items():
            if path[-1] == MANAGER:
                yield file, section


def named_sections(description: RosDescription) -> dict[str, Section]:
    """The parameters of each node in ROS 2, from all files."""
    sections: dict[str, Section] = {}
    for file, source in readable_files(description):
        for path, section in () if file.is_of_ros1 else _sections(source).items():
            whole = sections.setdefault(path[-1], Section({}, {}, section.at))
            whole.given.update(section.given)
            whole.places.update(section.places)
    return sections


@cached_by_source
def _sections(source: Source) -> dict[tuple[str, ...], Section]:
    """The parameters of each ROS node, by namespace and name; empty for ROS 1."""
    sections: dict[tuple[str, ...], Section] = {}
    for node in node_parameters(source):
        if node.path:
            sections.setdefault(node.path, Section({}, {}, node.at)).add(node.values)
    return sections


def _of_ros1(root: Node) -> Iterator[Controller]:
    """Mappings with a ``type`` that has a slash, in any namespace, and without a ``name``."""
    stack: list[tuple[str, Node, int]] = [("", root, -1)]
    while stack:
        name, node, above = stack.pop()
        node = mapping(node)
        kind = scalar(node, "type")
        if kind and "/" in kind.text:
            at = name.span if isinstance(name, Key) else kind.span
            section = Section({}, {}, at)
            section.add(node)
            yield Controller(name, kind.text, kind.span, 1, section, above)
        elif not isinstance(node.get("name"), Value):
            # With a name it is a record from which a program creates an object.
            stack += [(key, value, above + 1) for key, value in node.items()]

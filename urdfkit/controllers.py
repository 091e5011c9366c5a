"""The controllers of ros2_control in a YAML file, each value with its place.

The file is the one that a control plugin names in ``<parameters>``. It is read from the parser's
events, without recursion and without aliases, as ROS 2 reads it: a file of parameters has a few
levels, and what is deeper is no such file.
Source: ``rcl_yaml_param_parser`` of ros2/rcl.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from urdfkit.errors import UrdfkitError
from urdfkit.grammar import is_expression
from urdfkit.record import Record
from urdfkit.ros_control import control_plugins
from urdfkit.source import Source, Span

if TYPE_CHECKING:
    from typing import TypeAlias

    from urdfkit.document import Element
    from urdfkit.subject import Subject

#: Larger files are no list of controllers.
MAX_BYTES = 1024 * 1024
MAX_LEVELS = 30

_MANAGER = "controller_manager"
_PARAMETERS = "ros__parameters"


class Value(Record):
    """A scalar, and the lines and columns of its ends, from 0."""

    text: str
    source: Source
    start: tuple[int, int]
    end: tuple[int, int]

    @property
    def span(self) -> Span:
        """Its place, counted when it is asked for: the lines of a hostile file are long."""
        start, end = (self.source.offset(line + 1, column + 1) for line, column in self[2:])
        return Span(self.source, start, end)


#: None stands for an alias.
Node: TypeAlias = "Value | list[Node] | dict[str, Node] | None"


class Controller(Record):
    """A controller with a type.

    Attributes:
        name: of its node.
        type: its class, as the controller manager loads it.
        parameters: by name, with dots between levels; a single value is a list of one.
    """

    name: str
    type: str
    parameters: dict[str, list[Value]]

    def values(self, names: Iterable[str]) -> list[Value]:
        """What some parameters hold, one after the other."""
        return [value for name in names for value in self.parameters.get(name, ())]


class ParameterFile(Record):
    """A file that a control plugin names.

    Attributes:
        at: the ``<parameters>``.
        path: as it is after expansion; absolute.
        found: the file, or None if there is none.
    """

    at: Element
    path: str
    found: str | None


def parameter_files(subject: Subject) -> list[ParameterFile]:
    """The files that control plugins name by an absolute path, ``$(find pkg)`` among them."""
    files: dict[str, ParameterFile] = {}
    for plugin in control_plugins(subject.model):
        for element in plugin.at.all("parameters"):
            path = element.text.strip()
            if not path.startswith("/") or is_expression(path) or "\0" in path:
                continue
            found = path if os.path.isfile(path) else subject.resolver.installed(path)
            files.setdefault(path, ParameterFile(element, path, found))
    return list(files.values())


def controllers(subject: Subject) -> Iterator[tuple[ParameterFile, list[Controller]]]:
    """The controllers of each file that a control plugin names and that can be read."""
    for file in parameter_files(subject):
        if file.found and subject.resolver.allows(file.found, subject.source.path):
            try:
                source = subject.resolver.read(file.found)
            except UrdfkitError:
                continue
            yield file, read(source)


def read(source: Source) -> list[Controller]:
    """The controllers of a file; none if it is not YAML, or no file of parameters."""
    types: dict[tuple[str, ...], str] = {}
    parameters: dict[tuple[str, ...], dict[str, list[Value]]] = {}
    for path, node in _nodes(_load(source)):
        given = dict(_flat(node))
        parameters.setdefault(path, {}).update(given)
        prefixes = [("", path)]
        if path[-1] == _MANAGER:
            names = {name.rpartition(".")[0] for name in given if name.endswith(".type")}
            prefixes = [(f"{name}.", (*path[:-1], name)) for name in names]
        for prefix, owner in prefixes:
            if value := given.get(f"{prefix}type"):
                types[owner] = value[0].text
    return [Controller(p[-1], kind, parameters.get(p, {})) for p, kind in types.items()]


def _nodes(root: Node) -> Iterator[tuple[tuple[str, ...], dict[str, Node]]]:
    """The parameters of each ROS node, by namespace and name; ``**`` stands for any namespace."""
    stack: list[tuple[tuple[str, ...], Node]] = [((), root)]
    while stack:
        path, node = stack.pop()
        if not isinstance(node, dict):
            continue
        for key, inner in node.items():
            if key == _PARAMETERS and path and isinstance(inner, dict):
                yield path, inner
            elif key != _PARAMETERS:
                parts = [part for part in key.split("/") if part not in ("", "*", "**")]
                stack.append(((*path, *parts), inner))


def _flat(node: dict[str, Node]) -> Iterator[tuple[str, list[Value]]]:
    stack: list[tuple[str, Node]] = [("", node)]
    while stack:
        name, inner = stack.pop()
        if isinstance(inner, dict):
            stack += [(f"{name}.{key}" if name else key, value) for key, value in inner.items()]
        elif isinstance(inner, Value):
            yield name, [inner]
        elif isinstance(inner, list):
            yield name, [value for value in inner if isinstance(value, Value)]


def _load(source: Source) -> Node:
    """The first document of a YAML file."""
    if len(source.data) > MAX_BYTES:
        return None
    import yaml  # 15 ms, and few models name a file of parameters

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        return _compose(source, yaml.parse(source.data, loader))
    except yaml.YAMLError:
        return None


def _compose(source: Source, events: Iterable[Any]) -> Node:
    """The value that events make; None where it is too deep.

    Raises:
        yaml.YAMLError: it is not YAML.
    """
    import yaml

    top: list[Node] = []
    stack: list[Node] = [top]  # the collections that are open
    keys: list[str | None] = [None]  # of each, the key that waits for its value
    for event in events:
        if isinstance(event, yaml.DocumentEndEvent):
            break
        if isinstance(event, yaml.CollectionEndEvent):
            stack.pop()
            keys.pop()
            continue
        node = _node(source, event)
        owner = stack[-1]
        if isinstance(event, yaml.NodeEvent):
            if isinstance(owner, list):
                owner.append(node)
            elif isinstance(owner, dict):
                if keys[-1] is None:
                    keys[-1] = node.text if isinstance(node, Value) else ""
                else:
                    owner[keys[-1]] = node
                    keys[-1] = None
        if isinstance(event, yaml.CollectionStartEvent):
            stack.append(node)
            keys.append(None)
            if len(stack) > MAX_LEVELS:
                return None
    return top[0] if top else None


def _node(source: Source, event: Any) -> Node:
    import yaml

    if isinstance(event, yaml.ScalarEvent):
        ends: tuple[Any, Any] = (event.start_mark, event.end_mark)
        return Value(event.value, source, *((mark.line, mark.column) for mark in ends))
    if isinstance(event, yaml.MappingStartEvent):
        return {}
    return [] if isinstance(event, yaml.SequenceStartEvent) else None  # None for an alias

"""Node parameters in a YAML file of ROS 2, by node."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.text.located_yaml import Key, Node, Value, load, mapping
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

_PARAMETERS = "ros__parameters"


class NodeParameters(Record):
    """The parameters of a node in a file."""

    name: str  # of the node, without its namespace
    at: Span  # location of the name
    values: dict[str, Node]  # parameters; sections are mappings
    namespace: str = ""  # as in the file, with slashes between its parts


def node_parameters(source: Source) -> Iterator[NodeParameters]:
    """The nodes of a file, in order; keys above ``ros__parameters`` are namespaces."""
    stack: list[tuple[Node, Key | None, str]] = [(load(source), None, "")]
    while stack:
        node, parent, namespace_above = stack.pop()
        parameters = mapping(node).get(_PARAMETERS)
        if parent is not None and isinstance(parameters, dict):
            namespace, _, name = f"{namespace_above}/{parent}".rpartition("/")
            yield NodeParameters(name, parent.span, parameters, namespace)
            continue
        inner_namespace = f"{namespace_above}/{parent}" if parent else ""
        keys = [
            (key, value) for key, value in reversed(mapping(node).items()) if isinstance(key, Key)
        ]
        stack += [(value, key, inner_namespace) for key, value in keys]


def given_parameter(program: StartedProgram, name: str, resolver: Resolver) -> str | None:
    """A parameter of a node, from the launch file or its parameter files.

    Returns:
        An empty string if it is not given; None if it is known only at run time.
    """
    given = program.parameters
    if name in given.values:
        return given.values[name]
    if not given.is_whole or any(name in (word.text or name) for word in program.words):
        return None
    values: set[str | None] = set()
    for source in map(resolver.readable, given.files):
        if source is None:
            return None
        nodes = (node.values for node in node_parameters(source) if name in node.values)
        values.update(
            value.text if isinstance(value, Value) else None
            for value in (parameters[name] for parameters in nodes)
        )
    return next(iter(values), "") if len(values) < 2 else None

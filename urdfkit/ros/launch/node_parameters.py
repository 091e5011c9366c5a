"""The parameters of nodes in a YAML file of ROS 2, by node."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.text.located_yaml import Key, Node, load
from urdfkit.text.source import Source, Span

_PARAMETERS = "ros__parameters"


class NodeParameters(Record):
    """What a file says of one node."""

    name: str  # of the node, without its namespace
    at: Span  # where the name is written
    values: dict[str, Node]  # its parameters; those in sections are mappings


def node_parameters(source: Source) -> Iterator[NodeParameters]:
    """The nodes of a file, in its order; keys above ``ros__parameters`` are namespaces."""
    stack: list[tuple[Node, Key | None]] = [(load(source), None)]
    while stack:
        node, above = stack.pop()
        if not isinstance(node, dict):
            continue
        inside = node.get(_PARAMETERS)
        if above is not None and isinstance(inside, dict):
            yield NodeParameters(above.rpartition("/")[2], above.span, inside)
            continue
        stack += [(value, key) for key, value in reversed(node.items()) if isinstance(key, Key)]

"""Node parameters in a YAML file of ROS 2, by node.

Source: ``rcl_yaml_param_parser`` of ros2/rcl.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.text.located_yaml import Key, Node, items, load, mapping
from urdfkit.text.source import Source, Span
from urdfkit.text.source_cache import cached_by_source
from urdfkit.workspace.resolve import Resolver

#: The key below which the parameters of a node are.
PARAMETERS = "ros__parameters"


class NodeParameters(Record):
    """The parameters of a node in a file."""

    name: str  # of the node, without its namespace
    at: Span  # location of the name
    values: dict[str, Node]  # parameters; sections are mappings
    namespace: str = ""  # as in the file, with slashes between its parts
    kind: str = ""  # of the node in the catalogue, if its program is known

    @property
    def path(self) -> tuple[str, ...]:
        """The parts of its namespace, and its name; without ``*`` and ``**``, which are any."""
        parts = f"{self.namespace}/{self.name}".split("/")
        return tuple(part for part in parts if part not in ("", "*", "**"))

    def are_of(self, name: str) -> bool:
        """True for the parameters of a node with this name, or of all nodes."""
        return self.name in (name, "*", "**")


def nodes_in_files(paths: Iterable[str], resolver: Resolver) -> Iterator[NodeParameters]:
    """The nodes of parameter files, each file once; of those that are readable."""
    for source in filter(None, map(resolver.readable, dict.fromkeys(paths))):
        yield from node_parameters(source)


@cached_by_source  # many nodes load the same files, and rules read those of the workspace
def node_parameters(source: Source) -> tuple[NodeParameters, ...]:
    """The nodes of a file, in order; keys above ``ros__parameters`` are namespaces."""
    return tuple(_nodes(source))


def _nodes(source: Source) -> Iterator[NodeParameters]:
    stack: list[tuple[Node, Key | None, str]] = [(load(source), None, "")]
    while stack:
        node, parent, namespace_above = stack.pop()
        parameters = mapping(node).get(PARAMETERS)
        if parent is not None and isinstance(parameters, dict):
            namespace, _, name = f"{namespace_above}/{parent}".rpartition("/")
            yield NodeParameters(name, parent.span, parameters, namespace)
            continue
        inner_namespace = f"{namespace_above}/{parent}" if parent else ""
        inside = [(value, key, inner_namespace) for key, value in items(node)]
        stack += reversed(inside)

"""Parameters of nodes, and of plugins of Nav2: ``catalog/node_parameters.json``."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, items, scalar

#: The node of a costmap has the name of the costmap.
_COSTMAP = "_costmap"
#: Any parameter of a library that a node has, such as Rtabmap/DetectionRate.
_WITH_SLASH = "*/*"
#: What a node of robot_localization, which has any name, reads of an input.
CONFIGURATION = re.compile(r"((odom|imu|pose|twist)\d+)_config")


class GivenValue(Record):
    """A parameter in a file, of a node or plugin whose parameters are known."""

    name: str  # with the sections that it is in, below the node or the plugin
    at: Key  # its last part
    value: Node
    known: Mapping[str, str]  # the types of the parameters by name; ``any`` if they differ
    siblings: frozenset[str]  # the names next to it
    owner: str  # the node or the class of the plugin, in the catalogue

    @property
    def type(self) -> str | None:
        """The declared type; None if it is unknown, or differs between versions."""
        any_other = self.known.get(_WITH_SLASH) if "/" in self.at else None
        declared = self.known.get(self.name) or self.known.get(self.at) or any_other
        return None if declared == "any" else declared


def given_values(node: NodeParameters) -> Iterator[GivenValue]:
    """The parameters of a node, and those of its plugins."""
    if known := parameters_of_node(node):
        yield from _in_section(node.values, known, "", kind_of(node))


def has_parameter(node: NodeParameters, name: str) -> bool:
    """True if a node declares a parameter, whether it is given or not."""
    return name in parameters_of_node(node)


def _in_section(
    section: dict[str, Node], known: Mapping[str, str], prefix: str, owner: str
) -> Iterator[GivenValue]:
    siblings = frozenset(section)
    for key, value in items(section):
        if isinstance(value, dict):
            # The parameters of an unknown class are not known, but those of a section are: the
            # position of initial_pose, an observation source, a critic.
            if "plugin" in value:
                name = plugin_class(value)
                yield from _in_section(value, parameters_of_plugin(name), "", name)
            else:
                yield from _in_section(value, known, f"{prefix}{key}.", owner)
        elif known and key != "plugin":
            yield GivenValue(f"{prefix}{key}", key, value, known, siblings, owner)


def plugin_class(section: Node) -> str:
    """The class of a plugin as Jazzy and later write it, ``package::Class``; empty if unknown."""
    plugin = scalar(section, "plugin")
    return plugin.text.replace("/", "::") if plugin else ""


def parameters_of_plugin(name: str) -> dict[str, str]:
    """The types of the parameters of a plugin of Nav2, by name; empty for an unknown class."""
    return _types("plugins", name)


def parameters_of_node(node: NodeParameters) -> dict[str, str]:
    """The types of the parameters of a node by name; empty for an unknown node."""
    if inputs := [match.group(1) for key in node.values if (match := CONFIGURATION.fullmatch(key))]:
        by_type: dict[str, str] = data("node_parameters")["filter"]
        of_filter = [(name, kind) for kind, names in by_type.items() for name in names.split()]
        return {name.replace("*", topic): kind for name, kind in of_filter for topic in inputs}
    return _types("nodes", kind_of(node))


def kind_of(node: NodeParameters) -> str:
    """The name of a node in the catalogue."""
    if node.kind:
        return node.kind
    return "costmap" if node.name.endswith(_COSTMAP) else node.name


def _types(kind: str, name: str) -> dict[str, str]:
    """The types of the parameters of a node or plugin by name; empty if it is unknown."""
    by_type: dict[str, str] = data("node_parameters")[kind].get(name, {})
    return {name: kind for kind, names in by_type.items() for name in names.split()}

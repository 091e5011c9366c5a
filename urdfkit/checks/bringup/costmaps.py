"""The costmaps of Nav2, and the classes of their layers."""

from __future__ import annotations

from urdfkit.ros.launch.known_parameters import has_parameter, plugin_class
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Node, scalar, scalars

COSTMAPS = ("local_costmap", "global_costmap")


def class_of_layer(layer: Node) -> str:
    """The class of a layer without its package; empty if unknown."""
    return plugin_class(layer).rpartition("::")[2]


def class_of_active_layer(layer: Node) -> str:
    """The class of a layer without its package; empty if unknown, or if it is disabled."""
    enabled = scalar(layer, "enabled")
    return "" if enabled and enabled.boolean is False else class_of_layer(layer)


def has_default_plugins(node: NodeParameters, key: str, defaults: list[str]) -> bool:
    """True if a node loads the default plugins of a list, as it has no list or the same one."""
    if key not in node.values:
        return has_parameter(node, key)
    return [plugin.text for plugin in scalars(node.values[key])] == defaults

"""Layers of the costmaps of Nav2: their classes and observation sources.

Sources: ``costmap_plugins.xml`` and ``obstacle_layer.cpp`` of nav2_costmap_2d (humble to rolling).
"""

import re

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import plugin_class
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Node, Value, items, mapping, scalar, words

_PACKAGE = "nav2_costmap_2d"
_KIND = r"(Layer|Filter)s?$"
#: Least similarity of a misspelt layer: inflate is inflation, but semantic is not static.
_MIN_SIMILARITY = 0.75
_DATA = ("LaserScan", "PointCloud2")


def unknown_layer(layer: dict[str, Node]) -> Findings:
    """A misspelt layer class, and message types that an obstacle layer does not accept."""
    plugin = scalar(layer, "plugin")
    if plugin is None:
        return
    package, _, name = re.sub("::|/", " ", plugin.text).partition(" ")
    kinds = {re.sub(_KIND, "", known): known for known in data("nodes")["layers"].split()}
    near = nearest(re.sub(_KIND, "", name), kinds, _MIN_SIMILARITY) or ""
    suggested = kinds.get(near) if nearest(package, (_PACKAGE,)) else None
    if suggested and plugin.text != f"{_PACKAGE}::{suggested}":
        hint = f"'{plugin.text}'; did you mean '{_PACKAGE}::{suggested}'?"
        help = f"write {_PACKAGE}::{suggested}"
        yield Finding(plugin.span, f"unknown layer {hint}", help)
    for source in layer.values() if suggested in ("ObstacleLayer", "VoxelLayer") else ():
        kind = scalar(source, "data_type")
        if kind and kind.text not in _DATA:
            yield Finding(
                kind.span,
                f"unknown data_type '{kind.text}', which stops the costmap"
                f"{did_you_mean(kind.text, _DATA)}",
                f"write {' or '.join(_DATA)}",
            )


def sources_without_parameters(layer: dict[str, Node]) -> Findings:
    """Observation sources of a layer that have no section."""
    listed = scalar(layer, "observation_sources")
    sections = {name for name, value in layer.items() if isinstance(value, dict)}
    for name in listed.text.split() if listed else ():
        if listed and name not in sections:
            yield Finding(
                listed.span,
                f"observation source '{name}' has no parameters{did_you_mean(name, sections)}",
                f"add {name} with its topic and data_type, or fix the name",
                severity=Severity.WARNING,
            )


def misplaced_source_parameters(node: NodeParameters) -> Findings:
    """What a layer of a costmap reads of its sources, but not of itself."""
    for name, section in node.values.items():
        layer = mapping(section)
        names = words(layer, "observation_sources")
        read = data("node_parameters")["of_sources"].get(plugin_class(layer), "").split()
        for key, value in items(layer) if names else ():
            lacking = [source for source in names if key not in mapping(layer.get(source))]
            if key in read and lacking and isinstance(value, Value):
                yield Finding(
                    key.span,
                    f"'{node.name}' reads {key} of each source, not of '{name}'",
                    f"move it into the section of {lacking[0]}",
                )


def unlisted_sources(node: NodeParameters) -> Findings:
    """The sections of sources in a layer without a list of sources."""
    for name, section in node.values.items():
        layer = mapping(section)
        read = data("node_parameters")["of_sources"].get(plugin_class(layer), "").split()
        for key, value in items(layer) if read and "observation_sources" not in layer else ():
            if isinstance(value, dict) and not value.keys().isdisjoint(read):
                yield Finding(
                    key.span,
                    f"'{node.name}' reads no '{key}': '{name}' has no observation_sources",
                    f"write observation_sources: {key}",
                )

"""Plugins in the parameters of Nav2, and classes and observation sources of its costmaps.

Sources: ``costmap_plugins.xml`` and ``obstacle_layer.cpp`` of nav2_costmap_2d (humble to rolling).
"""

import re

from urdfkit.checks.bringup.costmaps import COSTMAPS, has_default_plugins
from urdfkit.core.suggest import CLOSE_TYPO, TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import plugin_class
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value, mapping, scalar, scalars, words

_PACKAGE = "nav2_costmap_2d"
_KIND = r"(Layer|Filter)s?$"
#: Least similarity of a misspelt layer: inflate is inflation, but semantic is not static.
_MIN_SIMILARITY = 0.75
#: The classes with a slash up to Iron, and colons from Jazzy on.
_RENAMED = re.compile(r"nav2_(?:behaviors|navfn_planner|smac_planner|theta_star_planner)(/|::)")
_DATA = ("LaserScan", "PointCloud2")


def plugins(node: NodeParameters) -> Findings:
    """Listed plugins without parameters, unknown classes and unknown observation sources."""
    sections = {name for name, value in node.values.items() if isinstance(value, dict)}
    for key, defaults in data("nodes")["lists"].items():
        if key in ("plugins", "filters") and node.name not in COSTMAPS:
            continue
        if has_default_plugins(node, key, defaults):
            continue
        for plugin in scalars(node.values.get(key)):
            if plugin.text not in sections and f"{plugin.text}.plugin" not in node.values:
                yield Finding(
                    plugin.span,
                    f"'{node.name}': no parameters for '{plugin.text}' of {key}"
                    f"{did_you_mean(plugin.text, sections)}",
                    f"add {plugin.text} with its plugin, or fix the name",
                )
    for layer in node.values.values():
        if isinstance(layer, dict):
            yield from _sources(layer)
            if node.name in COSTMAPS:
                yield from _layer(layer)


def unknown_classes(node: NodeParameters) -> Findings:
    """Classes of plugins that their package does not have; ``/`` and ``::`` are accepted."""
    known: list[str] = data("nodes")["plugins"].split()
    packages = {name.partition("::")[0] for name in known}
    for section in node.values.values() if node.name not in COSTMAPS else ():
        plugin, name = scalar(section, "plugin"), plugin_class(section)
        is_complete = name.partition("::")[0] in packages
        suggested = nearest(name, known, TYPO if is_complete else CLOSE_TYPO)
        if plugin is None or name in known or not (is_complete or suggested):
            continue
        hint = f"unknown plugin '{plugin.text}'"
        help = f"write a class that {name.partition('::')[0]} has"
        if suggested:
            suggested = suggested.replace("::", "/") if "/" in plugin.text else suggested
            hint, help = f"{hint}; did you mean '{suggested}'?", f"write {suggested}"
        yield Finding(plugin.span, hint, help, severity=Severity.WARNING)


def of_laser_filters(node: NodeParameters) -> Findings:
    """Misspelt filters of laser_filters, at which the chain stops."""
    known = data("nodes")["laser_filters"].split()
    for section in node.values.values():
        kind = scalar(section, "type")
        package, _, name = (kind.text if kind else "").partition("/")
        if kind is None or package != "laser_filters" or name in known:
            continue
        if suggested := nearest(name, known):
            message = f"'{node.name}' stops: unknown filter '{kind.text}'; did you mean "
            message += f"'{package}/{suggested}'?"
            yield Finding(kind.span, message, f"write {package}/{suggested}")


def types_of_docks(node: NodeParameters) -> Findings:
    """Docks of a type that is not among the plugins of the docking server."""
    types = [plugin.text for plugin in scalars(node.values.get("dock_plugins"))]
    for dock in scalars(node.values.get("docks")) if types else ():
        kind = scalar(node.values.get(dock.text), "type")
        if kind and kind.text not in types:
            message = f"dock '{dock.text}' has the type '{kind.text}', which dock_plugins lacks"
            help = f"write one of: {', '.join(types)}"
            message += did_you_mean(kind.text, types)
            yield Finding(kind.span, message, help, severity=Severity.WARNING)


def mixed_names(sections: list[NodeParameters]) -> Findings:
    """Classes that Nav2 renamed in Jazzy, from ``package/Class`` to ``package::Class``, mixed."""
    found: dict[str, list[Value]] = {"/": [], "::": []}
    for node in sections:
        for section in node.values.values():
            plugin = scalar(section, "plugin")
            if plugin and (match := _RENAMED.match(plugin.text)):
                found[match.group(1)].append(plugin)
    old, new = found["/"], found["::"]
    if old and new:
        fewer, sign = (old, "::") if len(old) <= len(new) else (new, "/")
        other = (new if fewer is old else old)[0].text
        yield Finding(
            fewer[0].span,
            f"plugin '{fewer[0].text}' has a name of "
            f"{'Iron and before' if fewer is old else 'Jazzy and later'}, unlike '{other}'",
            f"write {re.sub('/|::', sign, fewer[0].text)}",
            severity=Severity.WARNING,
        )


def _sources(layer: dict[str, Node]) -> Findings:
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


def of_sources(node: NodeParameters) -> Findings:
    """What a layer of a costmap reads of its sources, but not of itself."""
    for name, section in node.values.items():
        layer = mapping(section)
        names = words(layer, "observation_sources")
        read = data("node_parameters")["of_sources"].get(plugin_class(layer), "").split()
        for key, value in layer.items() if names else ():
            lacking = [source for source in names if key not in mapping(layer.get(source))]
            if key in read and lacking and isinstance(key, Key) and isinstance(value, Value):
                yield Finding(
                    key.span,
                    f"'{node.name}' reads {key} of each source, not of '{name}'",
                    f"move it into the section of {lacking[0]}",
                )


def _layer(layer: dict[str, Node]) -> Findings:
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

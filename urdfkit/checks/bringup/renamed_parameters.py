"""Parameters in the form of an earlier release of ROS, which a node no longer reads.

Sources: ``renamed`` in ``catalog/node_parameters.json``; ``bt_navigator.cpp`` of Jazzy and later,
which adds ``plugin_lib_names`` to its own libraries; ``twist_mux.cpp`` and ``params_helpers.hpp``.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.known_parameters import given_values, kind_of
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Key, Node, Value, items, mapping, scalars

_LIBRARIES = "plugin_lib_names"
_LIBRARY = re.compile(r"nav2_\w+_bt_node")
#: Releases before Jazzy in the path of a parameter file that is for one of them.
_OLDER = re.compile(r"humble|iron|galactic|foxy")
#: Releases before which a robot may still be.
_RECENT = ("Galactic", "Humble", "Iron", "realsense2_camera 4.55")
_MONITOR = "collision_monitor"
_MUX, _STAMPED = "twist_mux", "use_stamped"


def outdated(context: Context, sections: list[NodeParameters]) -> Findings:
    """Names of earlier releases in the parameters of a launch file."""
    names = {section.name for section in sections}
    started = {program.name for program in context.launch.started}
    of_older: list[Finding] = []
    for node in sections:
        yield from _unread_sections(node)
        renamed = list(_renamed(node))
        yield from (finding for since, finding in renamed if since not in _RECENT)
        if not _OLDER.search(node.at.source.path):
            of_older += (finding for since, finding in renamed if since in _RECENT)
            if node.name not in started:  # else the launch file gives the node its earlier name
                of_older += _renamed_node(node, names)
            of_older += _own_libraries(node)
            of_older += _unstamped(node)
            of_older += _listed_points(node)
    paths = [section.at.source.path for section in sections]
    if of_older and is_for_jazzy(context.source.path, context.resolver, paths):
        yield from of_older


def _renamed(node: NodeParameters) -> Iterator[tuple[str, Finding]]:
    """Parameters that are not read, and since when; an info if they have the default anyway."""
    renamed: dict[str, list[str]] = data("node_parameters")["renamed"].get(kind_of(node), {})
    stack: list[tuple[str, dict[str, Node]]] = [("", node.values)]
    while stack and renamed:
        prefix, section = stack.pop()
        stack += [
            (f"{prefix}{key}.", mapping(inner))
            for key, inner in section.items()
            if not _is_of_other_package(mapping(inner).get("plugin"))
        ]
        for key, value in items(section):
            facts = renamed.get(f"{prefix}{key}") or renamed.get(key) or ("", "", "")
            name, since, default = facts
            is_given = name in section or _has(node.values, name)
            if name and not is_given and not isinstance(value, dict):
                is_default = isinstance(value, Value) and value.text == default
                severity = Severity.INFO if is_default else Severity.WARNING
                message = (
                    f"'{node.name}' of {since} and later does not read '{prefix}{key}': it is "
                )
                help = f"write {name}: {_listed(value)}" if name == f"{key}s" else f"write {name}"
                yield since, Finding(key.span, f"{message}'{name}'", help, severity=severity)


def _is_of_other_package(plugin: Node | None) -> bool:
    """True for a plugin that does not come with Nav2, whose parameters have names of their own."""
    return isinstance(plugin, Value) and not plugin.text.startswith(("nav2_", "dwb_"))


def _has(values: dict[str, Node], name: str) -> bool:
    """True if a parameter such as ``pointcloud.enable`` is given, in whatever form."""
    *sections, last = name.split(".")
    return name in values or last in mapping(values, *sections)


def _listed(value: Node) -> str:
    return f"[{value.text}]" if isinstance(value, Value) else "as a list"


def _unread_sections(node: NodeParameters) -> Findings:
    """Values for which a node has a section, such as ``scale_linear`` of ROS 1."""
    for given in given_values(node):
        inner = [name for name in given.known if name.startswith(f"{given.name}.")]
        if inner and given.name not in given.known and isinstance(given.value, Value):
            names = ", ".join(name.rpartition(".")[2] for name in inner)
            yield _finding(
                given.at,
                f"'{node.name}': {given.at} is a value, but the node reads {inner[0]}",
                f"write a section: {given.at} with {names}",
            )


def _renamed_node(node: NodeParameters, names: set[str]) -> Findings:
    name, since = data("node_parameters")["renamed_nodes"].get(node.name, ("", ""))
    if name and name not in names:
        message = f"parameters of '{node.name}' are not read: the node of {since} and later is "
        yield Finding(node.at, f"{message}'{name}'", f"write {name}")


def _own_libraries(node: NodeParameters) -> Findings:
    """Libraries that the navigator loads anyway: the second time it stops."""
    listed = scalars(node.values.get(_LIBRARIES)) if node.name == "bt_navigator" else []
    own = [library for library in listed if _LIBRARY.fullmatch(library.text)]
    for library in own[:1]:
        count = f" and {len(own) - 1} more" if own[1:] else ""
        yield _finding(
            library,
            f"'{node.name}' of Jazzy and later stops: it loads '{library.text}'{count} anyway, "
            "and a behaviour is registered once",
            f"remove {_LIBRARIES}, except libraries of other packages",
        )


def _unstamped(node: NodeParameters) -> Findings:
    """A twist_mux that does not say whether its commands have stamps, at which it stops."""
    if node.name == _MUX and _STAMPED not in node.values and "topics" in node.values:
        message = f"'{_MUX}' of Jazzy and later stops: parameter '{_STAMPED}' is not given"
        help = f"add {_STAMPED}: true, or false for Twist"
        yield Finding(node.at, message, help)


def _listed_points(node: NodeParameters) -> Findings:
    """Points of polygons as numbers, which are a text since Iron."""
    for polygon in map(mapping, node.values.values()) if node.name == _MONITOR else ():
        points = scalars(polygon.get("points"))
        if points and len(points) == len(polygon["points"] or ()):
            texts = [point.text for point in points]
            pairs = ", ".join(f"[{x}, {y}]" for x, y in zip(texts[::2], texts[1::2], strict=False))
            yield _finding(
                points[0],
                f"'{node.name}' of Iron and later stops: points is a list, must be a string",
                f'write "[{pairs}]"',
            )


def _finding(at: Key | Value, message: str, help: str) -> Finding:
    return Finding(at.span, message, help)

"""A node stops because a parameter that it requires is not given.

- "parameter 'polygons' is not initialized": a node of Nav2 or a driver has other parameters, but
  not this one (warning).
- A polygon of the collision monitor has no shape, or fewer points than Jazzy requires (warning).
- An input of twist_mux has no topic, timeout or priority.

Sources:
    navigation2, polygon.cpp: https://github.com/ros-navigation/navigation2/blob/main/nav2_collision_monitor/src/polygon.cpp
    twist_mux, twist_mux.cpp: https://github.com/ros-teleop/twist_mux/blob/rolling/src/twist_mux.cpp
"""

import re

from urdfkit.checks.bringup.read_parameters import (
    OF_INPUT,
    inputs_of_twist_mux,
    read_sections,
    whole_sections,
)
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import mapping, scalar, scalars

NAME = "launch/monitor.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [
    Node(
        package="nav2_collision_monitor",
        executable="collision_monitor",
        parameters=["../monitor.yaml"],
    ),
]
"""
GOOD = BAD.replace("monitor.yaml", "sound.yaml")
_MONITOR = b"""\
collision_monitor:
  ros__parameters:
    observation_sources: []
    polygons: [stop]
    stop: {type: circle%s}
"""
FILES = {
    "monitor.yaml": _MONITOR % b"",
    "sound.yaml": _MONITOR % b", radius: 0.3",
    "package.xml": b"<package><name>arm</name></package>",
}

_MONITORS = ("collision_monitor", "collision_detector")
_TOPICS = ("polygon_sub_topic", "footprint_topic")
#: What a polygon of each type needs, unless a topic has it.
_SHAPES = {"polygon": "points", "circle": "radius", "velocity_polygon": "velocity_polygons"}
_LEAST = 4  # points, in Jazzy and Kilted; otherwise three
_POINT = re.compile(r"\[[^\[\],]+,[^\[\],]+\]")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    sections = read_sections(context)
    for section in sections:
        yield from _inputs_of_twist_mux(section)
    for section in whole_sections(sections):
        yield from _missing(section)
        yield from _incomplete_polygons(section)
    yield from _missing_of_programs(context)


def _inputs_of_twist_mux(node: NodeParameters) -> Findings:
    for name, values in inputs_of_twist_mux(node):
        for key in OF_INPUT:
            if key not in values:
                message = f"'{node.name}' stops: {key} of '{name}' is not given"
                yield Finding(name.span, message, f"add {key}")


def _missing(node: NodeParameters) -> Findings:
    """Parameters without which the node does not start; only if it has others."""
    required: dict[str, str] = data("node_parameters")["required"].get(node.name, {})
    for name, since in required.items():
        if name not in node.values and len(node.values) > 1:
            yield Finding(
                node.at,
                f"'{node.name}' of {since} stops: parameter '{name}' is not given",
                f"add {name}",
                severity=Severity.WARNING,
            )


def _missing_of_programs(context: Context) -> Findings:
    """The same for programs whose nodes have any name."""
    for program in context.launch.started:
        required: dict[str, str] = data("node_parameters")["required"].get(program.key, {})
        for parameter, since in required.items() if program.is_ros_2 else ():
            if given_parameter(program, parameter, context.resolver) == "":
                yield Finding(
                    program.at,
                    f"'{program.title}' of {since} stops: parameter '{parameter}' is not given",
                    f"add {parameter}",
                    severity=Severity.WARNING,
                )


def _incomplete_polygons(node: NodeParameters) -> Findings:
    """Polygons without a shape, or with too few points, at which the node stops."""
    names = scalars(node.values.get("polygons")) if node.name in _MONITORS else ()
    for name in (named.text for named in names):
        polygon = mapping(node.values, name)
        kind = scalar(polygon, "type")
        needed = _SHAPES.get(kind.text) if kind else None
        if kind is None or needed is None:
            continue
        has_topic = not polygon.keys().isdisjoint(_TOPICS) and needed != "velocity_polygons"
        is_approach = (action := scalar(polygon, "action_type")) and action.text == "approach"
        if needed not in polygon and not has_topic and not (is_approach and needed == "points"):
            yield Finding(
                kind.span,
                f"'{node.name}' stops: {kind.text} '{name}' has no {needed}",
                f"add {needed}"
                + (" or polygon_sub_topic" if needed != "velocity_polygons" else ""),
                severity=Severity.WARNING,
            )
        points = scalar(polygon, "points")
        count = len(_POINT.findall(points.text)) if points else 0
        if points and 0 < count < _LEAST and not has_topic:
            yield Finding(
                points.span,
                f"'{node.name}' of Jazzy stops: polygon '{name}' has {count} points, must have at "
                f"least {_LEAST}",
                "add points; a triangle may have one of them twice",
                severity=Severity.WARNING,
            )

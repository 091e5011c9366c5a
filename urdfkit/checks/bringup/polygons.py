"""The polygons of the collision monitor and detector of Nav2.

Source: ``polygon.cpp``, ``circle.cpp`` and ``velocity_polygon.cpp`` of nav2_collision_monitor
(iron to rolling).
"""

import re

from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import mapping, scalar, scalars

_MONITORS = ("collision_monitor", "collision_detector")
_TOPICS = ("polygon_sub_topic", "footprint_topic")
#: What a polygon of each type needs, unless a topic has it.
_SHAPES = {"polygon": "points", "circle": "radius", "velocity_polygon": "velocity_polygons"}
_LEAST = 4  # points, in Jazzy and Kilted; otherwise three
_POINT = re.compile(r"\[[^\[\],]+,[^\[\],]+\]")


def incomplete_polygons(node: NodeParameters) -> Findings:
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

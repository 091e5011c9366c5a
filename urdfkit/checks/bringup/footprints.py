"""The size of the robot in the costmaps of Nav2: its footprint or radius.

Sources: ``costmap_2d_ros.cpp`` and ``inflation_layer.cpp`` of nav2_costmap_2d, ``cost_critic.cpp``
of nav2_mppi_controller (humble to rolling).
"""

from __future__ import annotations

import re
from math import hypot, inf

from urdfkit.checks.bringup.costmaps import class_of_layer
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.robot.values import number
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Value, mapping, scalar

_CONSIDERED, _OF_FOOTPRINT = "consider_footprint", ("CostCritic", "ObstaclesCritic")
_SIDE = 5.0  # m, of a costmap, if not given
_TOLERANCE = 1e-6


def without_footprint(sections: list[NodeParameters]) -> Findings:
    """A critic of MPPI that considers the footprint of a robot that has only a radius."""
    costmaps = [node.values for node in sections if node.name == "local_costmap"]
    has_radius = len(costmaps) == 1 and "robot_radius" in costmaps[0]
    footprint = costmaps[0].get("footprint") if has_radius else None
    is_empty = isinstance(footprint, Value) and footprint.text == "[]"
    if not has_radius or (footprint and not is_empty):
        return
    for node in sections:
        is_controller = node.name == "controller_server"
        for plugin in map(mapping, node.values.values()) if is_controller else ():
            for name, critic in plugin.items():
                switch = scalar(critic, _CONSIDERED)
                if switch and switch.boolean and name in _OF_FOOTPRINT:
                    yield Finding(
                        switch.span,
                        f"'{node.name}' stops: {name} has {_CONSIDERED}, but local_costmap has "
                        "robot_radius and no footprint",
                        f"write {_CONSIDERED}: false, or give local_costmap a footprint",
                        severity=Severity.ERROR,
                    )


def wrong_radii(node: NodeParameters) -> Findings:
    """An inflation radius within the robot, and a radius that a footprint replaces."""
    radius, footprint = scalar(node.values, "robot_radius"), scalar(node.values, "footprint")
    points = _points(footprint.text) if footprint else []
    given = number(radius.text) if radius else None
    inscribed, circumscribed = _radii_of(points) if points else (given, None)
    if footprint and circumscribed and circumscribed > _size(node):
        yield Finding(
            footprint.span,
            f"'{node.name}': the footprint reaches {circumscribed:.3g} m from the robot, beyond "
            f"the costmap of {_size(node):g} m",
            "write the footprint in metres",
        )
        return
    least, most = (inscribed or 0.0) * 0.9, (circumscribed or inf) * 1.1
    if radius and given and circumscribed and not least <= given <= most:
        yield Finding(
            radius.span,
            f"'{node.name}': robot_radius {given:g} is not read: the costmap has a footprint, "
            f"of {inscribed:.3g} to {circumscribed:.3g} m",
            "remove robot_radius or the footprint",
        )
    for layer in map(mapping, node.values.values()):
        inflation = scalar(layer, "inflation_radius")
        width = number(inflation.text) if inflation else None
        is_inflation = class_of_layer(layer).endswith("InflationLayer")
        if inflation and is_inflation and inscribed and _is_below(width, inscribed):
            yield Finding(
                inflation.span,
                f"'{node.name}': inflation_radius {width:g} is below the inscribed radius of the "
                f"robot, {inscribed:.3g} m",
                f"write more than {inscribed:.3g}",
            )


def _is_below(width: float | None, bound: float) -> bool:
    return width is not None and width < bound - _TOLERANCE


def _size(node: NodeParameters) -> float:
    """The greater side of a costmap that moves with the robot, otherwise infinite."""
    rolling = scalar(node.values, "rolling_window")
    if rolling is None or not rolling.boolean:
        return inf
    sides = [scalar(node.values, side) for side in ("width", "height")]
    return max((number(side.text) or inf) if side else _SIDE for side in sides)


def _points(text: str) -> list[tuple[float, float]]:
    pairs = re.findall(r"\[\s*([^\[\],]+),\s*([^\[\],]+)\]", text)
    values = [(number(x.strip()), number(y.strip())) for x, y in pairs]
    known = [(x, y) for x, y in values if x is not None and y is not None]
    return known if len(known) == len(pairs) >= 3 else []


def _radii_of(points: list[tuple[float, float]]) -> tuple[float, float]:
    """The least distance of an edge from the origin, and the greatest of a corner."""
    edges = zip(points, points[1:] + points[:1], strict=True)
    return min(_distance(*edge) for edge in edges), max(hypot(*point) for point in points)


def _distance(start: tuple[float, float], end: tuple[float, float]) -> float:
    """The distance of a line segment from the origin."""
    x, y = end[0] - start[0], end[1] - start[1]
    length = x * x + y * y
    at = -(start[0] * x + start[1] * y) / length if length else 0.0
    at = min(1.0, max(0.0, at))
    return hypot(start[0] + at * x, start[1] + at * y)

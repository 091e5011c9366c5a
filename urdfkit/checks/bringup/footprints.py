"""The size of the robot in the costmaps of Nav2: its footprint or radius.

Sources: ``costmap_2d_ros.cpp`` and ``inflation_layer.cpp`` of nav2_costmap_2d, ``cost_critic.cpp``
of nav2_mppi_controller (humble to rolling).
"""

from __future__ import annotations

import re
from math import hypot, inf

from urdfkit.checks.bringup.costmaps import COSTMAPS, class_of_layer
from urdfkit.checks.bringup.published_robots import published_robots
from urdfkit.core.spatial import IDENTITY, Transform
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.robot.values import number
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Value, mapping, scalar

#: A point seen from above, in m.
Point = tuple[float, float]
#: Part of the distance of a wheel, and length in m, by which it may be outside of a footprint.
_EXCESS, _LEAST_EXCESS = 0.2, 0.03
_BASE, _WHEELS = "base_link", 2
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


def wheels_outside(context: Context, sections: list[NodeParameters]) -> Findings:
    """Footprints and radii that are too small for the wheels of the robot."""
    costmaps = [node for node in sections if node.name in COSTMAPS]
    robots = published_robots(context) if costmaps else []
    for node in costmaps if robots else ():
        base = scalar(node.values, "robot_base_frame")
        stands = [_standing_points(robot, base.text if base else _BASE) for robot in robots]
        footprint, radius = (scalar(node.values, key) for key in ("footprint", "robot_radius"))
        points = _points(footprint.text) if footprint else []
        given = number(radius.text) if radius else None
        if points and footprint:
            yield from _outside(node, footprint, stands, points, "footprint")
        elif radius and given:
            yield from _outside(node, radius, stands, [(given, 0.0)], f"robot_radius {given:g}")


def _outside(
    node: NodeParameters,
    at: Value,
    stands: list[list[Point]],
    points: list[Point],
    what: str,
) -> Findings:
    """A finding if a wheel of each robot is far outside of a footprint, or of a radius."""
    farthest = [max((_excess(one, points), one) for one in each) for each in stands if each]
    if len(farthest) < len(stands) or not farthest:
        return
    excess, wheel = min(farthest)
    reach = hypot(*wheel)
    if excess > max(_EXCESS * reach, _LEAST_EXCESS):
        yield Finding(
            at.span,
            f"'{node.name}': the {what} leaves out the wheels, which stand {reach:.3g} m from the "
            "centre of the robot",
            "write the outline of the robot, in metres",
        )


def _excess(point: Point, points: list[Point]) -> float:
    """How far a point is outside of a polygon, or of the circle of a single point; in m."""
    if len(points) == 1:
        return hypot(*point) - points[0][0]
    edges = list(zip(points, points[1:] + points[:1], strict=True))
    x, y = point
    crossed = [
        x < (end[0] - start[0]) * (y - start[1]) / (end[1] - start[1]) + start[0]
        for start, end in edges
        if (start[1] > y) is not (end[1] > y)
    ]
    is_inside = sum(crossed) % 2 == 1
    shifted = [((a[0] - x, a[1] - y), (b[0] - x, b[1] - y)) for a, b in edges]
    return 0.0 if is_inside else min(_distance(*edge) for edge in shifted)


def _standing_points(robot: Context, base: str) -> list[Point]:
    """Where a robot on wheels touches the ground, in the frame of its base; empty if unknown."""
    frame = robot.tree.frames.get(base) if robot.tree.is_sound else None
    stability = robot.stability_on_primitives if frame else None
    if frame is None or stability is None:
        return []
    parents = [robot.tree.parents.get(link, ()) for link in stability.links]
    wheels = sum(any(joint.kind == "continuous" for joint in joints) for joints in parents)
    if wheels < _WHEELS:
        return []
    inverse = frame.inverse
    places = (inverse @ Transform(IDENTITY, (x, y, 0.0)) for x, y in stability.polygon)
    return [place.position[:2] for place in places]


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

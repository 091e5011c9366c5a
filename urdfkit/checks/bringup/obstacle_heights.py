"""Heights of obstacles in a costmap that do not contain those of the robot's lidars.

Source: ``observation_buffer.cpp`` of nav2_costmap_2d (humble to rolling), which discards points of
other heights in the global frame.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.checks.bringup.published_robots import published_robots
from urdfkit.core.record import Record
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.gazebo.views import frame_of, planar_scan
from urdfkit.ros.node_parameters import NodeParameters
from urdfkit.text.located_yaml import Value, mapping, scalar, words

_MAX, _MIN = "max_obstacle_height", "min_obstacle_height"
_SCAN = "LaserScan"
#: In m: lidars are mounted lower than this bound, so that a greater one needs no robot.
_HIGH = 1.5
_TOLERANCE = 0.01


class _Bound(Record):
    """A height in the parameters of a layer or of a source."""

    value: Value
    key: str
    height: float  # in m
    source: str  # its name


def discarded_scans(context: Context, sections: list[NodeParameters]) -> Findings:
    """Bounds that exclude the planes of all lidars of the robot."""
    costmaps = (node for node in sections if node.name.endswith("_costmap"))
    bounds = [(node, bound) for node in costmaps for bound in _bounds(node)]
    robots = published_robots(context) if bounds else []
    heights = [pair for robot in robots for pair in _heights(robot)]
    for node, bound in bounds if heights else ():
        is_max = bound.key == _MAX
        outside = (
            height > bound.height + _TOLERANCE if is_max else height < bound.height - _TOLERANCE
            for _, height in heights
        )
        if all(outside):
            sensor, height = heights[0]
            yield Finding(
                bound.value.span,
                f"'{node.name}' marks nothing of '{bound.source}': {bound.key} is "
                f"{bound.height:g}, and {sensor.who} scans at a height of {height:.3g} m",
                f"write {'more' if is_max else 'less'} than {height:.3g}",
                related=(Related(sensor.at.span, sensor.who),),
            )


def _bounds(node: NodeParameters) -> Iterator[_Bound]:
    """The bounds of scans that may exclude a lidar."""
    for layer in map(mapping, node.values.values()):
        for name in words(layer, "observation_sources"):
            source, kind = mapping(layer, name), scalar(layer, name, "data_type")
            if kind and kind.text == _SCAN:
                yield from _low_maximum(scalar(source, _MAX), name)
                yield from _low_maximum(scalar(layer, _MAX), name)
                least = scalar(source, _MIN)
                height = number(least.text) if least else None
                if least and height:
                    yield _Bound(least, _MIN, height, name)


def _low_maximum(value: Value | None, source: str) -> Iterator[_Bound]:
    height = number(value.text) if value else None
    if value and height is not None and height < _HIGH:
        yield _Bound(value, _MAX, height, source)


def _heights(robot: Context) -> Iterator[tuple[Sensor, float]]:
    """The lidars of a robot that scan a plane, and their heights above its root in m."""
    for sensor in sensors(robot.model):
        frame = frame_of(sensor, robot.tree) if planar_scan(sensor) else None
        if frame is not None:
            yield sensor, frame.position[2]

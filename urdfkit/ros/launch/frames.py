"""The frames that files of a launch file name: parameters of nodes, and RViz's configuration."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.ros.launch.contents import Launch
from urdfkit.ros.launch.rviz import displays, manager_of
from urdfkit.text.located_yaml import Key, Node, Value, load, mapping
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: Parameters that name a frame of the robot: of robot_localization, Nav2, slam_toolbox, AMCL and
#: the controllers of wheels.
_OF_ROBOT = (
    "base_link_frame", "base_link_output_frame", "robot_base_frame", "base_frame", "base_frame_id",
    "sensor_frame",
)  # fmt: skip
#: Of costmaps, behaviours and the navigator: the frame of a map or of odometry.
GLOBAL = "global_frame"
_NAMING = (*_OF_ROBOT, GLOBAL)
_PARAMETERS = "ros__parameters"
#: In a value that is known at run time only.
_OPEN = ("$", "<", "{")


class NamedFrame(Record):
    """A frame that a file names."""

    name: str  # of the frame, without a slash before it
    who: str  # what names it, for messages
    key: str  # of the parameter; empty for RViz
    span: Span  # of the name
    named_at: Span  # where the launch file names the file


def named_frames(launch: Launch, resolver: Resolver) -> Iterator[NamedFrame]:
    """The frames of the robot that the files of a launch file name."""
    seen: set[str] = set()
    for file in launch.files:
        if not file.exists or file.path in seen:
            continue
        seen.add(file.path)
        if file.path.endswith((".yaml", ".yml")):
            found = _of_parameters
        elif file.path.endswith(".rviz"):
            found = _of_rviz
        else:
            continue
        source = resolver.readable(file.path)
        for who, key, value in found(source) if source else ():
            name = value.text.strip().lstrip("/")
            if name and not any(mark in name for mark in _OPEN):
                yield NamedFrame(name, who, key, value.span, file.span)


def _of_parameters(source: Source) -> Iterator[tuple[str, str, Value]]:
    """The frames in the parameters of nodes in ROS 2."""
    if not any(key.encode() in source.data for key in _NAMING):
        return
    stack: list[tuple[Node, bool]] = [(load(source), False)]
    while stack:
        node, is_inside = stack.pop()
        for key, value in mapping(node).items():
            if is_inside and key in _NAMING and isinstance(value, Value):
                yield key, key, value
            elif isinstance(value, dict) and isinstance(key, Key):
                stack.append((value, is_inside or key == _PARAMETERS))


def _of_rviz(source: Source) -> Iterator[tuple[str, str, Value]]:
    """The frames in a configuration of RViz: the fixed one, and those of displays that are on."""
    fixed = mapping(manager_of(source), "Global Options").get("Fixed Frame")
    if isinstance(fixed, Value):
        yield "Fixed Frame of RViz", "", fixed
    for display in displays(source):
        frame = display.get("Reference Frame")
        if isinstance(frame, Value):
            yield "display of RViz", "", frame

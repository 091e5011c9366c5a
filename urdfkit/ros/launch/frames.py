"""Frame references in files of a launch file: node parameters, and RViz's configuration."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.cartographer import configurations
from urdfkit.ros.launch.contents import Launch
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.rviz import displays, manager_of
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.text.located_yaml import Value, entries, is_template, mapping
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: Parameters with a frame of the robot: of robot_localization, Nav2, slam_toolbox, AMCL, wheel
#: controllers and laser_filters.
_OF_ROBOT = (
    "base_link_frame", "base_link_output_frame", "robot_base_frame", "base_frame", "base_frame_id",
    "sensor_frame", "box_frame", "polygon_frame",
)  # fmt: skip
#: Of costmaps, behaviours and the navigator: the frame of a map or of odometry.
GLOBAL = "global_frame"
_OF_CARTOGRAPHER = ("tracking_frame", "published_frame")
FRAMES = (*_OF_ROBOT, GLOBAL)


class NamedFrame(Record):
    """A frame reference in a file."""

    name: str  # of the frame, without a leading slash
    who: str  # owner of the reference, for messages
    key: str  # of the parameter; empty for RViz
    span: Span  # of the name; of the node for a default
    named_at: Span | None  # location of the file's reference in the launch file; None for a default


def named_frames(launch: Launch, resolver: Resolver) -> Iterator[NamedFrame]:
    """References to frames of the robot in the files of a launch file."""
    read_paths: set[str] = set()
    for file in launch.files:
        if not file.exists or file.path in read_paths:
            continue
        read_paths.add(file.path)
        if file.path.endswith((".yaml", ".yml")):
            references = _of_parameters
        elif file.path.endswith(".rviz"):
            references = _of_rviz
        else:
            continue
        source = resolver.readable(file.path)
        for owner, key, value in references(source) if source else ():
            name = value.text.strip().lstrip("/")
            if name and not is_template(name):
                yield NamedFrame(name, owner, key, value.span, file.span)


def frames_of_cartographer(launch: Launch, resolver: Resolver) -> Iterator[NamedFrame]:
    """Frames in the configurations of Cartographer nodes that the file itself starts."""
    for configuration in configurations(launch.started, resolver):
        for key in _OF_CARTOGRAPHER:
            option = configuration.options.get(key)
            if option and option.text and not launch.has_scopes:
                at, named_at = option.span, configuration.name.span
                yield NamedFrame(option.text.lstrip("/"), key, key, at, named_at)


def default_frames(launch: Launch, resolver: Resolver) -> Iterator[NamedFrame]:
    """Frames of the robot that nodes of the file itself use because no parameter is given."""
    for node in launch.programs if not launch.has_scopes else ():
        defaults: dict[str, str] = data("nodes")["defaults"].get(node.package, {})
        for key in defaults.keys() & _OF_ROBOT if node.frame is None and node.is_sure else ():
            if given_parameter(node, key, resolver) == "":
                who = f"default {key} of '{node.executable}':"
                yield NamedFrame(defaults[key], who, key, node.span, None)


def sensor_frames(launch: Launch, resolver: Resolver) -> Iterator[NamedFrame]:
    """The frames in which drivers of sensors that the file itself starts publish their data."""
    for node in launch.started if not launch.has_scopes else ():
        facts = data("nodes")["frames"].get(node.key, "").split()
        value = given_parameter(node, facts[0], resolver) if facts and node.is_sure else None
        frame = value or facts[1] if value is not None and len(facts) > 1 else value
        if frame and not is_template(frame):
            span = node.parameters.at.get(facts[0], node.span)
            who = f"{facts[0]} of '{node.title}':"
            yield NamedFrame(frame.lstrip("/"), who, facts[0], span, None)


def _of_parameters(source: Source) -> Iterator[tuple[str, str, Value]]:
    """The frames in the parameters of nodes in ROS 2."""
    if not any(key.encode() in source.data for key in FRAMES):
        return
    for node in node_parameters(source):
        for key, value in entries(node.values):
            if key == "base_frame_id" and "camera_name" in node.values:
                continue  # realsense2_camera puts the name of the camera before it
            if key in FRAMES and isinstance(value, Value):
                yield key, key, value


def _of_rviz(source: Source) -> Iterator[tuple[str, str, Value]]:
    """Frames in an RViz configuration: the fixed frame, and those of enabled displays."""
    fixed = mapping(manager_of(source), "Global Options").get("Fixed Frame")
    if isinstance(fixed, Value):
        yield "Fixed Frame of RViz", "", fixed
    for display in displays(source):
        frame = display.get("Reference Frame")
        if isinstance(frame, Value):
            yield "display of RViz", "", frame

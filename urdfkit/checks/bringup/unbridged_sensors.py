"""Sensors of a robot in Gazebo whose topic a node reads, and that no bridge forwards."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator

from urdfkit.checks.bringup.read_topics import ReadTopic
from urdfkit.checks.bringup.unread_commands import is_part_of_ros
from urdfkit.checks.bringup.workspace_launches import distinct_descriptions, programs_of
from urdfkit.core.suggest import CLOSE_TYPO, nearest
from urdfkit.lint.rules import Context, Finding
from urdfkit.ros.gazebo.topics import GazeboTopic, topics
from urdfkit.ros.launch.bridges import bridged_topics, is_bridge
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.workspace.launch_files import launch_files

_IMAGE_BRIDGE = "ros_gz_image"
_BRIDGES = ("ros_gz_bridge", "ros_ign_bridge", _IMAGE_BRIDGE)
#: Bridges that are not read: former packages.
_OTHER_BRIDGE = re.compile(rb"ros_ign_")
#: The message of Gazebo for one of ROS; the package of those of ROS that are not in sensor_msgs.
_IN_GAZEBO = {"Imu": "IMU", "NavSatFix": "NavSat", "PointCloud2": "PointCloudPacked"}
_IN_GAZEBO |= {name: name for name in ("CameraInfo", "Image", "LaserScan", "Odometry")}
_IN_ROS = {"Odometry": "nav_msgs"}


def sensors_of_workspace(context: Context, launches: tuple[Launch, ...]) -> list[GazeboTopic]:
    """What robots publish in Gazebo and no bridge forwards; empty if a bridge may be unknown."""
    if not _has_known_bridges(context, launches):
        return []
    names = [
        topic.topic
        for node in _bridges(launches)
        for topic in bridged_topics(node, context.resolver)
    ]
    return [
        topic
        for description, robot in context.expanded(distinct_descriptions(launches))
        for topic in (topics(robot.model) if description.is_whole else ())
        if not topic.is_read and not any(map(topic.is_called, names))
    ]


def unbridged_sensor(
    sensors: Iterable[GazeboTopic], read: ReadTopic, published: Collection[str]
) -> GazeboTopic | None:
    """What publishes a topic in Gazebo, of the same name or below the same first part.

    If nothing publishes such messages in ROS, its topic may have any name.
    """
    message, name = _IN_GAZEBO.get(read.message), read.topic.strip("/")
    likely = [sensor for sensor in sensors if sensor.message == message]
    called = [sensor for sensor in likely if sensor.is_called(name)]
    first = name.partition("/")[0]
    below = [sensor for sensor in likely if sensor.name.startswith(f"{first}/")]
    if published:
        is_typo = nearest(f"/{name}", published, CLOSE_TYPO) is not None
        return next(iter(called or ([] if is_typo else below)), None)
    by_name = {sensor.name: sensor for sensor in called or below or likely}
    return by_name[nearest(name, by_name, 0) or next(iter(by_name))] if by_name else None


def unbridged(read: ReadTopic, name: str, sensor: GazeboTopic) -> Finding:
    kind = f"{_IN_ROS.get(read.message, 'sensor_msgs')}/msg/{read.message}"
    of_sensor = "" if sensor.is_unnamed else f" '/{sensor.name}'"
    return Finding(
        read.at,
        f"'{read.who}' waits for '{name}', which nothing publishes: no bridge forwards the topic"
        f"{of_sensor} of {sensor.who}",
        f"add it to the bridge, with {kind} and gz.msgs.{sensor.message}",
    )


def _has_known_bridges(context: Context, launches: tuple[Launch, ...]) -> bool:
    """True if the workspace has bridges, all of whose topics are known."""
    bridges = list(_bridges(launches))
    directory = context.resolver.packages.workspace(context.source.path)
    return (
        bool(bridges)
        and all(_is_known_bridge(node, context) for node in bridges)
        and all(is_part_of_ros(path) for launch in launches for path in launch.unread)
        and not any(
            _OTHER_BRIDGE.search(source.data)
            for source in launch_files(directory, "", context.resolver)
        )
    )


def _bridges(launches: Iterable[Launch]) -> Iterator[StartedProgram]:
    return (node for node in programs_of(launches) if node.package in _BRIDGES)


def _is_known_bridge(program: StartedProgram, context: Context) -> bool:
    """False if some topics of a bridge are known only at run time."""
    given = program.parameters.every
    path = (given or {}).get("config_file", "")
    is_read = path == "" or (path is not None and context.resolver.readable(path) is not None)
    is_plain = is_bridge(program) or program.package == _IMAGE_BRIDGE
    return is_plain and given is not None and is_read and all(word.text for word in program.words)

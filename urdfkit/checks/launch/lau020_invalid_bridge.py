"""The bridge between Gazebo and ROS cannot pass on a topic.

`ros_gz_bridge` knows pairs of messages. For another pair it prints "Failed to create a bridge for
topic" and goes on with the rest, so that the topic is there on one side and silent on the other.
The same happens to an entry of its YAML file without both types or with another direction than
`GZ_TO_ROS`, `ROS_TO_GZ` or `BIDIRECTIONAL`. A word of its command line that is no
`topic@ros_type@gz_type`, with `[` from Gazebo and `]` to Gazebo, ends the program. So does a name
that ROS rejects: Gazebo's `/model/bot/joint/arm/0/cmd_pos` has a part that begins with a digit.
Messages that are not in the table of urdfkit are not reported, for later releases add some.

A topic that no sensor or system of the robot publishes or reads, while one with that message has
another topic that is not passed on, is a warning; the topics of `image_bridge` of ros_gz_image are
images. A sensor without `<topic>` publishes below `/world/NAME/model/NAME/link/...`; the
`camera_info` of a camera is next to its images. A topic that is passed on in the wrong direction
only, such as `/clock` to Gazebo, is a warning, too. So is one of a message that no sensor and no
system of the robot has, where the world is known to hold no other one.

Sources:
    ros_gz_bridge, parameter_bridge.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/src/parameter_bridge.cpp
    ros_gz_bridge, bridge_config.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/src/bridge_config.cpp
    gazebosim/ros_gz#269: https://github.com/gazebosim/ros_gz/issues/269
    ros_gz_bridge, mappings.py: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/ros_gz_bridge/mappings.py
"""

import os
import re
from collections.abc import Iterator

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.gazebo.topics import GazeboTopic, are_all_known, topics
from urdfkit.ros.gazebo.worlds import read_world
from urdfkit.ros.launch.bridges import (
    DIRECTIONS,
    FROM_GAZEBO,
    KEYS,
    SIGNS,
    TO_GAZEBO,
    BridgedTopic,
    all_messages,
    bridged_topics,
    gazebo_messages,
    ros_messages,
)
from urdfkit.ros.launch.worlds import worlds
from urdfkit.text.document import CallFrame

NAME = "robot.launch.py"
BAD = """\
from launch_ros.actions import Node

bridge = Node(
    package="ros_gz_bridge",
    executable="parameter_bridge",
    arguments=["/imu@sensor_msgs/msg/Imu[gz.msgs.Pose"],
)
"""
GOOD = BAD.replace("gz.msgs.Pose", "gz.msgs.IMU")

#: The time of the simulation, which Gazebo itself publishes.
_OF_GAZEBO = tuple(GazeboTopic("Gazebo", "Clock", name) for name in ("clock", "world/*/clock"))
#: Messages that a robot alone publishes or reads, but for models of the world.
_OF_ROBOTS = (
    "CameraInfo", "IMU", "Image", "LaserScan", "Model", "NavSat", "Odometry", "PointCloudPacked",
    "Twist",
)  # fmt: skip


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    bridged = [
        (topic, started.frame)
        for started in (*context.launch.started, *context.launch.included)
        for topic in bridged_topics(started, context.resolver)
    ]
    for topic, frame in bridged:
        if mistake := next(_mistakes(topic), None):
            key, message, help = mistake
            yield Finding(Location(topic.at(key), frame), message, help)
        for key, span in topic.unknown:
            if meant := nearest(key, KEYS, 0.6):
                message = f"the bridge does not read '{key}'; did you mean '{meant}'?"
                at = Location(span, frame)
                yield Finding(at, message, f"write {meant}", severity=Severity.WARNING)
    yield from _silent(context, bridged)


def _mistakes(topic: BridgedTopic) -> Iterator[tuple[str, str, str]]:
    """Why the bridge does not pass a topic on: the key, the reason, and what to write."""
    if not topic.ros_type or not topic.gz_type:
        yield (
            "ros_type_name" if topic.ros_type else "gz_type_name",
            f"the bridge of '{topic.topic}' lacks the message type of {_lacking(topic)}",
            "write topic@package/msg/Name[gz.msgs.Name, or ros_type_name and gz_type_name",
        )
    if topic.direction not in DIRECTIONS:
        hint = did_you_mean(topic.direction, DIRECTIONS)
        yield (
            "direction",
            f"unknown direction '{topic.direction}'{hint}",
            f"write one of {', '.join(DIRECTIONS)}",
        )
    part = next((one for one in topic.ros_topic.split("/") if re.match(r"\d", one)), "")
    if part:
        yield (
            "ros_topic_name" if "ros_topic_name" in topic.places else "topic_name",
            f"ROS rejects the topic '{topic.ros_topic}': '{part}' begins with a digit",
            "give it another ros_topic_name in a config_file, and keep gz_topic_name",
        )
    package, _, name = topic.ros_type.partition("/")
    if "/msg/" not in topic.ros_type and gazebo_messages(f"{package}/msg/{name}"):
        right = f"{package}/msg/{name}"
        yield (
            "ros_type_name",
            f"the bridge knows no message '{topic.ros_type}'; did you mean '{right}'?",
            f"write {right}",
        )
    prefix, _, message = topic.gz_type.rpartition(".")
    known = gazebo_messages(topic.ros_type)
    if known is None:
        return
    right = f"write gz.msgs.{known[0]}"
    if prefix not in ("gz.msgs", "ignition.msgs"):
        yield "gz_type_name", f"'{topic.gz_type}' is no message of Gazebo", right
    elif message not in known and (message in all_messages() or nearest(message, known, 0.7)):
        pair = f"'{topic.ros_type}' and '{topic.gz_type}'"
        both = [f"{prefix}.{one} for {topic.ros_type}" for one in known]
        both += [f"{one} for {topic.gz_type}" for one in ros_messages(message)]
        help = f"write {' or '.join(both)}" if message in all_messages() else right
        yield "gz_type_name", f"the bridge cannot convert {pair}", help


def _lacking(topic: BridgedTopic) -> str:
    return "ROS" if not topic.ros_type else "Gazebo"


def _silent(context: Context, bridged: list[tuple[BridgedTopic, CallFrame | None]]) -> Findings:
    """The topics that pass nothing on, where a sensor or system waits for a bridge in vain."""
    of_robot = list(_topics(context))
    passed = {topic.topic for topic, _ in bridged}
    is_known = _is_known(context)
    unnamed: set[str] = set()
    unbridged = [one for one in of_robot if not any(map(one.is_called, passed))]
    for topic, frame in bridged:
        own = [one for one in (*of_robot, *_OF_GAZEBO) if one.is_called(topic.topic)]
        only = {FROM_GAZEBO: True, TO_GAZEBO: False}.get(topic.direction)
        if only is not None and own and all(one.is_read is only for one in own):
            verb, right = ("reads", TO_GAZEBO) if only else ("publishes", FROM_GAZEBO)
            message = f"{topic.direction} passes nothing on: {own[0].who} {verb} '{topic.topic}'"
            at = Location(topic.at("direction"), frame)
            help = f"write {right if topic.places else SIGNS[right]}"
            yield Finding(at, message, help, severity=Severity.WARNING)
        wanted = topic.gz_type.rpartition(".")[2]
        waiting = [one for one in unbridged if one.message == wanted and one.is_read is not only]
        at = Location(topic.at("gz_topic_name", "topic_name", "ros_topic_name"), frame)
        if not own and waiting:
            other = _nearest(topic.topic, waiting)
            if other.is_unnamed and other.who in unnamed:
                continue  # the same <topic> gives it this one, too
            unnamed.add(other.who)
            yield Finding(at, *_unknown(topic.topic, other), severity=Severity.WARNING)
        elif not own and is_known and wanted in _OF_ROBOTS:
            verb = "reads" if topic.direction == TO_GAZEBO else "publishes"
            message = f"nothing in Gazebo {verb} '{topic.topic}': the robot has no sensor and no "
            message += f"system with {topic.gz_type}"
            help = "add one to the robot, or remove the topic from the bridge"
            yield Finding(at, message, help, severity=Severity.WARNING)


def _is_known(context: Context) -> bool:
    """True if all that publishes or reads such messages in Gazebo is in the one robot."""
    robots, started = list(context.described_robots), list(worlds(context.launch))
    return (
        len(robots) == len(started) == 1
        and all(description.is_whole for description, _ in robots)
        and all(are_all_known(robot.model) for _, robot in robots)
        and (started[0].is_shipped or _is_bare(started[0].name, context))
    )


def _is_bare(path: str, context: Context) -> bool:
    """True for a world in whose models there is no sensor and no system."""
    try:
        world, _ = read_world(path, context.resolver) if os.path.isabs(path) else (None, ())
    except UnreadableFile:
        return False
    every = list(world.at.walk()) if world else []
    plugins = [one for one in every if one.tag == "plugin"]
    is_foreign = any(one.tag in ("sensor", "include", "population") for one in every)
    return world is not None and not is_foreign and len(plugins) == len(world.plugins)


def _nearest(topic: str, waiting: list[GazeboTopic]) -> GazeboTopic:
    known = {one.name: one for one in waiting}
    return known[nearest(topic.strip("/"), known, 0) or next(iter(known))]


def _unknown(topic: str, other: GazeboTopic) -> tuple[str, str]:
    """Message and help for a topic that the robot does not have, by one that it has."""
    nothing = f"nothing in the robot has the topic '{topic}'"
    if other.is_unnamed:
        place = "plugin" if other.is_system else "sensor"
        return (
            f"{nothing}: {other.who} has no <{other.tag}>",
            f"write <{other.tag}>{other.named(topic)}</{other.tag}> into the {place}",
        )
    message = f"{nothing}; that of {other.who} is '/{other.name}', which is not bridged"
    if other.name.strip("'\"") != other.name:
        return f"{message}: the quotes are part of it", "remove the quotes in the robot's <topic>"
    return message, f"write /{other.name}"


def _topics(context: Context) -> Iterator[GazeboTopic]:
    """The topics of the robots that are described; none if not all of them are known."""
    for description, robot in context.described_robots:
        if description.is_whole:
            yield from topics(robot.model)

"""The bridge between Gazebo and ROS cannot pass on a topic.

`ros_gz_bridge` knows pairs of messages. For another pair it prints "Failed to create a bridge for
topic" and goes on with the rest, so that the topic is there on one side and silent on the other.
The same happens to an entry of its YAML file without both types or with another direction than
`GZ_TO_ROS`, `ROS_TO_GZ` or `BIDIRECTIONAL`. A word of its command line that is no
`topic@ros_type@gz_type`, with `[` from Gazebo and `]` to Gazebo, ends the program. Messages that
are not in the table of urdfkit are not reported, for later releases add some.

A topic on which no sensor of the robot publishes, while a sensor with that message publishes on
another one that is not passed on, is a warning.

Sources:
    ros_gz_bridge, parameter_bridge.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/src/parameter_bridge.cpp
    ros_gz_bridge, bridge_config.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/src/bridge_config.cpp
    ros_gz_bridge, mappings.py: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/ros_gz_bridge/mappings.py
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.launch.bridges import (
    DIRECTIONS,
    KEYS,
    TO_GAZEBO,
    BridgedTopic,
    all_messages,
    bridged_topics,
    gazebo_messages,
)
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


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(subject: Context) -> Findings:
    topics = [
        (topic, started.frame)
        for started in (*subject.launch.started, *subject.launch.included)
        for topic in bridged_topics(started, subject.resolver)
    ]
    for topic, frame in topics:
        if mistake := next(_mistakes(topic), None):
            yield Finding(Location(topic.span, frame), *mistake)
        for key, span in topic.unknown:
            if meant := nearest(key, KEYS, 0.8):
                message = f"the bridge does not read '{key}'; did you mean '{meant}'?"
                at = Location(span, frame)
                yield Finding(at, message, f"write {meant}", severity=Severity.WARNING)
    yield from _unpublished(subject, topics)


def _mistakes(topic: BridgedTopic) -> Iterator[tuple[str, str]]:
    """Why the bridge does not pass a topic on, and what to write."""
    if not topic.ros_type or not topic.gz_type:
        yield (
            f"the bridge of '{topic.topic}' lacks the message type of {_lacking(topic)}",
            "write topic@package/msg/Name[gz.msgs.Name, or ros_type_name and gz_type_name",
        )
    if topic.direction not in DIRECTIONS:
        hint = did_you_mean(topic.direction, DIRECTIONS)
        yield (
            f"unknown direction '{topic.direction}'{hint}",
            f"write one of {', '.join(DIRECTIONS)}",
        )
    package, _, name = topic.ros_type.partition("/")
    if "/msg/" not in topic.ros_type and gazebo_messages(f"{package}/msg/{name}"):
        right = f"{package}/msg/{name}"
        yield (
            f"the bridge knows no message '{topic.ros_type}'; did you mean '{right}'?",
            f"write {right}",
        )
    prefix, _, message = topic.gz_type.rpartition(".")
    known = gazebo_messages(topic.ros_type)
    if known is None:
        return
    right = f"write gz.msgs.{known[0]}"
    if prefix not in ("gz.msgs", "ignition.msgs"):
        yield f"'{topic.gz_type}' is no message of Gazebo", right
    elif message not in known and (message in all_messages() or nearest(message, known, 0.7)):
        pair = f"'{topic.ros_type}' and '{topic.gz_type}'"
        expected = " or ".join(f"'{prefix}.{one}'" for one in known)
        yield f"the bridge cannot convert {pair}; the second is {expected}", right


def _lacking(topic: BridgedTopic) -> str:
    return "ROS" if not topic.ros_type else "Gazebo"


def _unpublished(subject: Context, topics: list[tuple[BridgedTopic, CallFrame | None]]) -> Findings:
    """The topics on which no sensor publishes, where one waits for a bridge in vain."""
    messages = data("bridge")["sensors"]
    passed = {_plain(topic.topic) for topic, _ in topics}
    silent = [(s, name) for s, name in _published(subject) if _plain(name) not in passed]
    names = {_plain(name) for _, name in _published(subject)}
    for topic, frame in topics:
        message = topic.gz_type.rpartition(".")[2]
        waiting = [(s, name) for s, name in silent if messages.get(s.type) == message]
        if _plain(topic.topic) in names or len(waiting) != 1 or topic.direction == TO_GAZEBO:
            continue
        sensor, name = waiting[0]
        yield Finding(
            Location(topic.span, frame),
            f"no sensor of the robot publishes on '{topic.topic}'; {sensor.who} publishes on "
            f"'{name}', which is not bridged",
            f"write {name}",
            severity=Severity.WARNING,
        )


def _published(subject: Context) -> Iterator[tuple[Sensor, str]]:
    """The sensors of the robots that are described, with the topics that they name."""
    for description in subject.launch.descriptions:
        robot = subject.other_robot(description.path, description.arguments)
        if robot.reading.document is None:
            continue
        for sensor in sensors(robot.model):
            topic = sensor.find("topic")
            if topic is not None and topic.text.strip():
                yield sensor, topic.text.strip()


def _plain(topic: str) -> str:
    return topic.strip("/")

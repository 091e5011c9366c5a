"""The bridge between Gazebo and ROS cannot forward a topic.

`ros_gz_bridge` converts fixed pairs of message types. For another pair it prints "Failed to create
a bridge for topic" and continues, so that the topic has no messages on the other side. The same
happens to an entry of its YAML file that lacks a type, or has another direction than `GZ_TO_ROS`,
`ROS_TO_GZ` or `BIDIRECTIONAL`. An argument that is not `topic@ros_type@gz_type`, with `[` from
Gazebo and `]` to Gazebo, stops the program. So does a name that ROS rejects: Gazebo's
`/model/bot/joint/arm/0/cmd_pos` has a part that begins with a digit. A file that is not YAML, or is
a mapping, not a list, has no topics. Message types that urdfkit does not know are not reported:
later releases may support them.

Reported as a warning:

- No sensor or system of the robot uses the topic, while another topic with the same message type
  is not bridged. The topics of `image_bridge` of ros_gz_image are images. A sensor without
  `<topic>` publishes below `/world/NAME/model/NAME/link/...`; the `camera_info` of a camera is next
  to its images. A topic that the xacro has with other arguments is not reported.
- An entry of the file has a key twice, as two have without the dash of the second.
- The bridge has parameters, but neither `config_file` nor topics as arguments.
- The topic is bridged only in the wrong direction, such as `/clock` to Gazebo.
- Two topics of sensors are bridged to one topic of ROS: images of two cameras alternate on it. Or
  one is bridged twice, also by two bridges, as the clock often is.
- No sensor or system of the robot uses the message type, and the world contains no other model
  that may.

Sources:
    ros_gz_bridge, parameter_bridge.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/src/parameter_bridge.cpp
    ros_gz_bridge, bridge_config.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/src/bridge_config.cpp
    gazebosim/ros_gz#591: https://github.com/gazebosim/ros_gz/issues/591
    gazebosim/ros_gz#269: https://github.com/gazebosim/ros_gz/issues/269
    ros_gz_bridge, mappings.py: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_bridge/ros_gz_bridge/mappings.py
"""

import re
from collections.abc import Iterator
from itertools import pairwise

from urdfkit.checks.bringup.topics_without_messages import topics_without_messages
from urdfkit.core.suggest import CLOSE_TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.ros.launch.bridges import (
    DIRECTIONS,
    FROM_GAZEBO,
    KEYS,
    BridgedTopic,
    all_messages,
    bridged_topics,
    config_path,
    gazebo_messages,
    is_bridge,
    ros_messages,
    ros_types,
)
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.text.located_yaml import Value, items, load, syntax_error
from urdfkit.text.source import Source

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

#: Messages of a single sensor.
_OF_SENSORS = ("CameraInfo", "Image", "Imu", "LaserScan", "PointCloud2")
#: Parameters of the bridge that name its topics.
_OF_TOPICS = ("bridge_names", "config_file")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from _merged(context)
    for program in context.launch.programs:
        yield from _without_topics(program)
        yield from _not_a_list(program, context)
        yield from _joined(program, context)
    bridged = [
        (topic, program.frame)
        for program in context.launch.programs
        for topic in bridged_topics(program, context.resolver)
    ]
    for topic, frame in bridged:
        if mistake := next(_mistakes(topic), None):
            key, message, help = mistake
            yield Finding(Location(topic.at(key), frame), message, help)
        for key, span in topic.unknown:
            if suggested := nearest(key, KEYS):
                message = f"the bridge does not read '{key}'; did you mean '{suggested}'?"
                at = Location(span, frame)
                yield Finding(at, message, f"write {suggested}", severity=Severity.WARNING)
    yield from topics_without_messages(context, bridged)


def _without_topics(program: StartedProgram) -> Findings:
    """A bridge with parameters, none of which names topics."""
    given = program.parameters.every
    is_bare = program.executable == "parameter_bridge" and not program.words
    names = {*(given or ()), *program.parameters.lists}
    if given and is_bare and is_bridge(program) and names.isdisjoint(_OF_TOPICS):
        message = "the bridge has no topics: neither arguments nor config_file"
        help = 'write {"config_file": PATH} in its parameters'
        at = program.at
        yield Finding(at, message, help, severity=Severity.WARNING)


def _file_of(program: StartedProgram, context: Context) -> Source | None:
    path = config_path(program) if is_bridge(program) else None
    return context.resolver.readable(path) if path else None


def _not_a_list(program: StartedProgram, context: Context) -> Findings:
    """A file of topics that is not YAML, or a mapping, as of a single topic without its dash."""
    source = _file_of(program, context)
    if source and (error := syntax_error(source)):
        at, reason = error
        message = f"the bridge has no topics: invalid YAML: {reason}"
        yield Finding(Location(at, program.frame), message, "fix the file")
        return
    first = next(items(load(source)), None) if source else None
    if first:
        key, value = first
        message = "the bridge has no topics: the file is a mapping, must be a list"
        help = f"write - {key}: ..., and the other keys below it"
        if isinstance(value, list):
            help = f"remove {key}: and write its list as the whole file"
        yield Finding(Location(key.span, program.frame), message, help)


def _joined(program: StartedProgram, context: Context) -> Findings:
    """An entry that repeats a key, as two do without the dash of the second."""
    source = _file_of(program, context)
    entries = load(source) if source else None
    for entry in entries if isinstance(entries, list) else ():
        for (key, value), (after, _) in pairwise(items(entry)):
            # The place of a key is the first, that of its value the last.
            if isinstance(value, Value) and value.span.start > after.span.start:
                yield Finding(
                    Location(value.span, program.frame),
                    f"'{key}' is given twice in one entry: the bridge has one topic of two",
                    f"write - before the second {key}",
                    severity=Severity.WARNING,
                )
                break


def _merged(context: Context) -> Findings:
    """Topics of Gazebo that bridges publish on one topic of ROS, of the same message."""
    first: dict[tuple[object, ...], BridgedTopic] = {}
    for program, topic in _published(context):
        is_absolute = topic.ros_topic.startswith("/")
        is_named = is_absolute or not (context.launch.has_scopes or program.namespace is None)
        # Another bridge may run instead of one with a condition, or in another namespace.
        is_comparable = is_named and program.is_sure and not program.is_remapped
        key = (topic.ros_topic.strip("/"), topic.ros_type, None if is_comparable else id(program))
        other = first.setdefault(key, topic)
        if other is topic:
            continue
        at, help = topic.span, "remove one of the two"
        message = f"'{topic.topic}' is bridged twice: each message arrives twice on "
        if other.topic.strip("/") != topic.topic.strip("/"):
            at = topic.at("ros_topic_name", "topic_name")
            help = "give one of them another ros_topic_name"
            message = f"'{topic.topic}' and '{other.topic}' of Gazebo are both published on "
        yield Finding(
            Location(at, program.frame),
            f"{message}'{topic.ros_topic}'",
            help,
            related=(Related(other.span, "the other one"),),
            severity=Severity.WARNING,
        )


def _published(context: Context) -> Iterator[tuple[StartedProgram, BridgedTopic]]:
    """The topics of sensors, and the clock, that bridges publish in ROS."""
    for program in context.launch.programs:
        for topic in bridged_topics(program, context.resolver):
            name = topic.ros_type.rpartition("/")[2]
            if topic.direction == FROM_GAZEBO and name in (*_OF_SENSORS, "Clock"):
                yield program, topic


def _mistakes(topic: BridgedTopic) -> Iterator[tuple[str, str, str]]:
    """Reasons why the bridge does not forward a topic: key, message and help."""
    if not topic.ros_type or not topic.gz_type:
        lacking = "Gazebo" if topic.ros_type else "ROS"
        yield (
            "ros_type_name" if topic.ros_type else "gz_type_name",
            f"the bridge of '{topic.topic}' lacks the message type of {lacking}",
            "write topic@package/msg/Name[gz.msgs.Name, or ros_type_name and gz_type_name",
        )
    if topic.direction not in DIRECTIONS:
        hint = did_you_mean(topic.direction, DIRECTIONS)
        help = f"write one of {', '.join(DIRECTIONS)}"
        yield "direction", f"unknown direction '{topic.direction}'{hint}", help
    part = next((part for part in topic.ros_topic.split("/") if re.match(r"\d", part)), "")
    if part:
        yield (
            "ros_topic_name" if "ros_topic_name" in topic.places else "topic_name",
            f"ROS rejects the topic '{topic.ros_topic}': '{part}' begins with a digit",
            "give it another ros_topic_name in a config_file, and keep gz_topic_name",
        )
    if suggested := _ros_type(topic.ros_type):
        message = f"unknown message type '{topic.ros_type}'; did you mean '{suggested}'?"
        yield "ros_type_name", message, f"write {suggested}"
    yield from _wrong_gazebo_types(topic)


def _ros_type(written: str) -> str | None:
    """The message type that a misspelt one means; None if it is known, or resembles none."""
    package, _, name = written.partition("/")
    if "/msg/" not in written and gazebo_messages(f"{package}/msg/{name}"):
        return f"{package}/msg/{name}"
    if gazebo_messages(written):
        return None
    return nearest(written, ros_types(), CLOSE_TYPO) or _in_other_package(written)


def _in_other_package(written: str) -> str | None:
    """The message of this name in another package of ROS: ``std_msgs`` has no ``Image``."""
    package, _, name = written.partition("/msg/")
    known = ros_types()
    if not any(other.startswith(f"{package}/") for other in known):
        return None  # a package of the user, whose messages a bridge of the user may convert
    return next((other for other in known if other.endswith(f"/msg/{name}")), None)


def _wrong_gazebo_types(topic: BridgedTopic) -> Iterator[tuple[str, str, str]]:
    known = gazebo_messages(topic.ros_type)
    if known is None:
        return
    prefix, _, message = topic.gz_type.rpartition(".")
    is_message = message in all_messages()
    right = f"write gz.msgs.{known[0]}"
    if prefix not in ("gz.msgs", "ignition.msgs"):
        yield "gz_type_name", f"'{topic.gz_type}' is not a Gazebo message type", right
    # Gazebo has few messages with the names of ROS.
    elif message not in known and (
        is_message or message == topic.ros_type.rpartition("/")[2] or nearest(message, known)
    ):
        pair = f"'{topic.ros_type}' and '{topic.gz_type}'"
        both = [f"{prefix}.{name} for {topic.ros_type}" for name in known]
        both += [f"{ros_type} for {topic.gz_type}" for ros_type in ros_messages(message)]
        help = f"write {' or '.join(both)}" if is_message else right
        yield "gz_type_name", f"the bridge cannot convert {pair}", help

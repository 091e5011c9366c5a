"""Topics that ros_gz_bridge and ros_gz_image pass between Gazebo and ROS.

Sources: words of the command line, or a YAML file.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache, lru_cache

from urdfkit.core.record import Record
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import StartedProgram, Word
from urdfkit.ros.launch.spawned_controllers import resolve_name
from urdfkit.text.located_yaml import CACHE_SIZE, Node, Value, load, mapping
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver

#: The keys of an entry of the file.
KEYS = (
    "topic_name", "ros_topic_name", "gz_topic_name", "ros_type_name", "gz_type_name", "direction",
    "publisher_queue", "subscriber_queue", "lazy", "publish_optical_frame", "qos_profile",
    "service_name", "gz_req_type_name", "gz_rep_type_name",
)  # fmt: skip
FROM_GAZEBO, TO_GAZEBO, BOTH = "GZ_TO_ROS", "ROS_TO_GZ", "BIDIRECTIONAL"
DIRECTIONS = (FROM_GAZEBO, TO_GAZEBO, BOTH)

CONFIG_FILE = "config_file:="
#: The parameter with which names of Gazebo in a file begin with the namespace of the bridge, too.
EXPANDS_NAMES = "expand_gz_topic_names"
_IMAGE_PACKAGES = ("ros_gz_image", "ros_ign_image")
#: Characters for directions in a command line.
SIGNS = {FROM_GAZEBO: "[", TO_GAZEBO: "]", BOTH: "@"}


class BridgedTopic(Record):
    """A topic of a bridge."""

    span: Span  # source location: a word, or the first value of an entry
    #: topic and ros_topic: names in Gazebo and in ROS.
    topic: str
    ros_topic: str
    #: ros_type and gz_type: of its messages, such as ``sensor_msgs/msg/Imu`` and ``gz.msgs.IMU``;
    #: empty if missing.
    ros_type: str
    gz_type: str
    direction: str  # one of `DIRECTIONS`, if valid
    #: Keys of the entry that the bridge does not read, with their locations.
    unknown: tuple[tuple[str, Span], ...] = ()
    places: Mapping[str, Span] = {}  # of the values of an entry, by key

    def at(self, *keys: str) -> Span:
        """Location of the first of several keys that exists."""
        return next((self.places[key] for key in keys if key in self.places), self.span)


def gazebo_messages(ros_type: str) -> tuple[str, ...] | None:
    """The Gazebo messages of a ROS message; None for an unknown message."""
    return tuple(gz for ros, gz in _converted() if ros == ros_type) or None


def ros_types() -> list[str]:
    """The ROS messages that the bridge converts, such as ``sensor_msgs/msg/Imu``."""
    return list(dict.fromkeys(ros for ros, _ in _converted()))


def all_messages() -> tuple[str, ...]:
    """The Gazebo messages that the bridge supports."""
    return tuple(dict.fromkeys(gz for _, gz in _converted()))


def ros_messages(gz_message: str) -> tuple[str, ...]:
    """The ROS messages to which the bridge converts a Gazebo message such as ``Double``."""
    return tuple(ros for ros, gz in _converted() if gz == gz_message)


@cache
def _converted() -> tuple[tuple[str, str], ...]:
    """The messages that the bridge converts: of ROS and of Gazebo."""
    return tuple(
        (f"{package}/msg/{ros}", gz)
        for package, pairs in data("bridge")["messages"].items()
        for ros, gz in map(str.split, pairs.split(", "))
    )


def is_bridge(program: StartedProgram) -> bool:
    is_executable = program.executable in ("parameter_bridge", "bridge_node")
    return is_executable and program.package in ("ros_gz_bridge", "ros_ign_bridge")


def config_file(words: Iterable[Word]) -> Word | None:
    """The file of ``-p config_file:=PATH`` in a command line; None if it is missing."""
    for word in words:
        if word.text and word.text.startswith(CONFIG_FILE):
            return Word(word.text.removeprefix(CONFIG_FILE), word.span)
    return None


def config_path(program: StartedProgram) -> str | None:
    """The file of a bridge's topics, from its command line or its parameters; None without one."""
    config = config_file(program.words)
    return config.text if config else program.parameters.values.get("config_file")


def bridged_topics(program: StartedProgram, resolver: Resolver) -> Iterator[BridgedTopic]:
    """Topics of a bridge of ros_gz, with the namespace of the bridge; empty for other programs."""
    space = program.namespace
    is_expanding = (program.parameters.values.get(EXPANDS_NAMES) or "").lower() == "true"
    for topic in _topics(program, resolver):
        is_below = is_expanding and bool(topic.places)
        yield topic._replace(
            ros_topic=_below(space, topic.ros_topic),
            topic=_below(space, topic.topic) if is_below else topic.topic,
        )


def _below(namespace: str | None, topic: str) -> str:
    """The full name of a topic in a namespace."""
    is_relative = namespace and not topic.startswith("/")
    return resolve_name(topic, namespace or "") if is_relative else topic


def _topics(program: StartedProgram, resolver: Resolver) -> Iterator[BridgedTopic]:
    if program.executable == "image_bridge" and program.package in _IMAGE_PACKAGES:
        yield from _images(program)
    if not is_bridge(program):
        return
    path = config_path(program)
    for word in program.words:
        if topic := _of_word(word):
            yield topic
    source = resolver.readable(path) if path else None
    if source:
        yield from _in_file(source)


def _images(program: StartedProgram) -> Iterator[BridgedTopic]:
    """Topics of images, each a word of the command line; the ROS topic has the same name."""
    for word in program.words:
        text = word.text or ""
        if text.startswith("-"):
            return  # --ros-args
        if text and ":=" not in text:
            types = ("sensor_msgs/msg/Image", "gz.msgs.Image")
            yield BridgedTopic(word.span, text, text, *types, FROM_GAZEBO)


def _of_word(word: Word) -> BridgedTopic | None:
    """The topic of a word of the command line; None for a service or an unknown word."""
    text = word.text
    if text is None or "@" not in text or "/srv/" in text:
        return None
    topic, _, types = text.partition("@")
    directions = {sign: direction for direction, sign in SIGNS.items()}
    sign = next((char for char in types if char in directions), "")
    ros_type, _, rest = types.partition(sign) if sign else (types, "", "")
    gz_type, _, ros_topic = rest.partition("@")
    return BridgedTopic(
        word.span, ros_topic or topic, topic, ros_type, gz_type, directions.get(sign, "")
    )


@lru_cache(CACHE_SIZE)  # each launch file of a workspace looks at the bridges of all of them
def _in_file(source: Source) -> tuple[BridgedTopic, ...]:
    entries = load(source)
    topics = map(_of_entry, entries if isinstance(entries, list) else ())
    return tuple(topic for topic in topics if topic)


def _of_entry(entry: Node) -> BridgedTopic | None:
    """The topic of an entry of the file; None for a service, or without a value."""
    values = {str(key): value for key, value in mapping(entry).items() if isinstance(value, Value)}
    texts = {key: value.text for key, value in values.items()}
    if not values or "service_name" in texts:
        return None
    places = {key: value.span for key, value in values.items()}
    topic = next((texts[key] for key in ("gz_topic_name", "topic_name") if key in texts), "")
    return BridgedTopic(
        next(iter(places.values())),
        topic or texts.get("ros_topic_name", ""),
        texts.get("ros_topic_name") or texts.get("topic_name") or topic,
        texts.get("ros_type_name", ""),
        texts.get("gz_type_name", ""),
        texts.get("direction", BOTH),
        tuple((key, place) for key, place in places.items() if key not in KEYS),
        places,
    )

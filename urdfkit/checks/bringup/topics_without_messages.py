"""Topics of a bridge without messages: nothing in Gazebo publishes or reads them."""

import os
import re
from collections.abc import Iterator

from urdfkit.checks.bringup.workspace_launches import robots_of_workspace
from urdfkit.core.suggest import nearest
from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Finding, Findings, Location, Severity
from urdfkit.lint.switched_off import all_sources
from urdfkit.ros.gazebo.topics import GazeboTopic, are_all_known, topics
from urdfkit.ros.gazebo.worlds import read_world
from urdfkit.ros.launch.bridges import FROM_GAZEBO, SIGNS, TO_GAZEBO, BridgedTopic
from urdfkit.ros.launch.spawning import spawns_sdf
from urdfkit.ros.launch.worlds import worlds
from urdfkit.text.comments import blank_comments
from urdfkit.text.document import CallFrame, Element

_CLOCK = "Clock"
#: Topics that Gazebo itself publishes: the simulation time, and the poses of all models.
_OF_GAZEBO = (
    *(GazeboTopic("Gazebo", _CLOCK, name) for name in ("clock", "world/*/clock")),
    *(GazeboTopic("Gazebo", "Pose_V", f"world/*/{name}/info") for name in ("pose", "dynamic_pose")),
)
#: Message types that only robots and models of the world publish or read.
_OF_ROBOTS = (
    "CameraInfo", "IMU", "Image", "LaserScan", "Model", "NavSat", "Odometry", "PointCloudPacked",
    "Twist",
)  # fmt: skip
#: The message of transforms, and the package whose filters publish that of odometry, too.
_TRANSFORM, _ESTIMATOR = "Pose_V", "robot_localization"
_ADD = "add one to the robot, or remove the topic from the bridge"
#: The topic of transforms that do not change, and the system that alone publishes it.
_STATIC = "pose_static"
_ADD_STATIC = (
    "add gz::sim::systems::PosePublisher with <static_publisher>true</static_publisher>, or remove "
    "the topic: robot_state_publisher has these transforms, too"
)
#: The link in the default topic of a sensor.
_LINK = re.compile(r"/link/([^/]+)/sensor/")
#: A topic in a tag, such as ``<odom_topic>``, or in an argument of a macro.
_TOPIC = rb"""<(?=\w*topic)\w+>\s*([\w/.-]+)\s*<|\b(?=\w*topic)\w+\s*=\s*["']([\w/.-]+)["']"""


def topics_without_messages(
    context: Context, bridged: list[tuple[BridgedTopic, CallFrame | None]]
) -> Findings:
    """Topics that are unused in Gazebo, or bridged in the wrong direction."""
    if any(map(spawns_sdf, context.launch.programs)):
        return  # the robot in Gazebo is not the described one
    of_robot = list(_topics(context))
    of_other_arguments = set(_topics_of_other_arguments(context))
    names = {topic.topic for topic, _ in bridged}
    unbridged = [gz for gz in of_robot if not any(map(gz.is_called, names))]
    served = {gz.who for gz in of_robot if gz not in unbridged}
    is_known = _is_known(context)
    unnamed: set[str] = set()
    for topic, frame in bridged:
        own = [gz for gz in (*of_robot, *_OF_GAZEBO) if gz.is_called(topic.topic)]
        name = topic.topic.strip("/")
        if own:
            if not any(_passes(topic, gz) for gz in own):
                yield _wrong_direction(topic, own[0].who, frame)
            elif all(gz.is_unnamed for gz in own):
                yield from _unknown_link(context, topic, own[0].who, frame)
            continue
        # Launch files of several robots may share a file of topics.
        is_shared = topic.places and _is_of_another_robot(context, topic)
        if is_shared or not of_other_arguments.isdisjoint((name, name.rpartition("/")[0])):
            continue
        kind = topic.gz_type.rpartition(".")[2]
        waiting = [gz for gz in unbridged if gz.message == kind and gz.tag and _passes(topic, gz)]
        at = Location(topic.at("gz_topic_name", "topic_name", "ros_topic_name"), frame)
        if waiting:
            other = _nearest(topic.topic, waiting, served)
            # A <topic> in this sensor names all its topics.
            is_static = name.rpartition("/")[2] == _STATIC
            if other is None or is_static:
                help = _ADD_STATIC if is_static else _ADD
                yield Finding(at, _nothing(topic.topic), help, severity=Severity.WARNING)
                continue
            if not other.is_unnamed or other.who not in unnamed:
                message, help = _unknown_topic(topic.topic, other)
                help = _unless_estimated(context, kind) + help
                yield Finding(at, message, help, severity=Severity.WARNING)
            unnamed.add(other.who)
        else:
            yield from _of_nothing(topic, kind, at, is_known=is_known)


def _of_nothing(topic: BridgedTopic, kind: str, at: Location, *, is_known: bool) -> Findings:
    """A topic that nothing publishes or reads, as far as this is certain."""
    if kind == _CLOCK:
        message = f"Gazebo publishes no clock as '{topic.topic}'"
        help = "write /clock, or /world/NAME/clock"
        yield Finding(at, message, help, severity=Severity.WARNING)
    elif is_known and kind in _OF_ROBOTS:
        verb = "reads" if topic.direction == TO_GAZEBO else "publishes"
        message = f"nothing in Gazebo {verb} '{topic.topic}': the robot has no sensor and no "
        message += f"system with {topic.gz_type}"
        yield Finding(at, message, _ADD, severity=Severity.WARNING)


def _is_of_another_robot(context: Context, topic: BridgedTopic) -> bool:
    """True for a topic of a robot of another launch file of the workspace."""
    return any(
        gz.is_called(topic.topic) and not gz.is_unnamed
        for robot in robots_of_workspace(context)
        for gz in topics(robot.model)
    )


def _unless_estimated(context: Context, message: str) -> str:
    """The help, before that for a topic, for transforms that a filter publishes; else empty."""
    is_estimated = any(program.package == _ESTIMATOR for program in context.launch.programs)
    is_transform = message == _TRANSFORM and is_estimated
    return f"remove it if {_ESTIMATOR} publishes the transform; else " if is_transform else ""


def _passes(topic: BridgedTopic, gz: GazeboTopic) -> bool:
    """True if the bridge forwards the messages of a topic of Gazebo, or those that it reads."""
    return topic.direction != (FROM_GAZEBO if gz.is_read else TO_GAZEBO)


def _wrong_direction(topic: BridgedTopic, who: str, frame: CallFrame | None) -> Finding:
    is_read = topic.direction == FROM_GAZEBO
    verb, right = ("reads", TO_GAZEBO) if is_read else ("publishes", FROM_GAZEBO)
    return Finding(
        Location(topic.at("direction"), frame),
        f"wrong direction {topic.direction}: {who} {verb} '{topic.topic}'",
        f"write {right if topic.places else SIGNS[right]}",
        severity=Severity.WARNING,
    )


def _unknown_link(
    context: Context, topic: BridgedTopic, who: str, frame: CallFrame | None
) -> Findings:
    """The topic of a sensor without ``<topic>`` with a link that the robot does not have."""
    match = _LINK.search(topic.topic)
    links = {name for _, robot in context.described_robots for name in robot.model.links_by_name}
    if match and links and match[1] not in links:
        yield Finding(
            Location(topic.at("gz_topic_name", "topic_name"), frame),
            f"'{topic.topic}' names link '{match[1]}', which the robot does not have",
            f"write /world/WORLD/model/ROBOT/link/LINK/sensor/NAME/..., or give {who} a <topic>",
            severity=Severity.WARNING,
        )


def _is_known(context: Context) -> bool:
    """True if the robot alone publishes and reads topics in Gazebo."""
    robots, started_worlds = list(context.described_robots), list(worlds(context.launch))
    return (
        len(robots) == len(started_worlds) == 1
        and all(description.is_whole for description, _ in robots)
        and all(are_all_known(robot.model) for _, robot in robots)
        and (started_worlds[0].is_shipped or _is_bare(started_worlds[0].name, context))
    )


def _is_bare(path: str, context: Context) -> bool:
    """True for a world whose models have no sensors and no systems."""
    try:
        world, _ = read_world(path, context.resolver) if os.path.isabs(path) else (None, ())
    except UnreadableFile:
        return False
    elements = list(world.at.walk()) if world else []
    plugins = [element for element in elements if element.tag == "plugin"]
    is_foreign = any(element.tag in ("sensor", "include", "population") for element in elements)
    return world is not None and not is_foreign and len(plugins) == len(world.plugins)


def _nearest(topic: str, waiting: list[GazeboTopic], served: set[str]) -> GazeboTopic | None:
    """The most similar topic; a lidar whose scan is bridged also has points, which few bridge.

    None if other topics of all these sensors are bridged, and none of them is similar.
    """
    first = topic.strip("/").partition("/")[0]
    likely = [gz for gz in waiting if gz.who not in served or gz.name.startswith(f"{first}/")]
    known = {gz.name: gz for gz in likely or waiting}
    similar = nearest(topic.strip("/"), known)
    if similar is None and not likely:
        return None
    return known[similar or nearest(topic.strip("/"), known, 0) or next(iter(known))]


def _nothing(topic: str) -> str:
    return f"no sensor or system of the robot has the topic '{topic}'"


def _unknown_topic(topic: str, other: GazeboTopic) -> tuple[str, str]:
    """Message and help for a topic that the robot does not have; ``other`` is the nearest."""
    nothing = _nothing(topic)
    if other.is_unnamed:
        place = "plugin" if other.is_system else "sensor"
        return (
            f"{nothing}: {other.who} has no <{other.tag}>",
            f"write <{other.tag}>{other.named(topic)}</{other.tag}> into the {place}",
        )
    message = f"{nothing}; the topic '/{other.name}' of {other.who} is not bridged"
    if other.name.strip("'\"") != other.name:
        return f"{message}: the quotes are part of it", "remove the quotes in the robot's <topic>"
    return message, f"write /{other.name}"


def _topics(context: Context) -> Iterator[GazeboTopic]:
    """Topics of the robots whose descriptions are fully known."""
    for description, robot in context.described_robots:
        if description.is_whole:
            yield from topics(robot.model)


def _topics_of_other_arguments(context: Context) -> Iterator[str]:
    """Topics in the xacro files of the robots that they only have with other arguments."""
    for _, robot in context.described_robots:
        if robot.reading.xacro is None:
            continue
        elements = list(robot.document.root.walk())
        used = {at.text.strip().strip("/") for at in elements if "topic" in at.tag}
        called = _expanded_calls(elements)
        for source in all_sources(robot):
            data = blank_comments(source.data)
            for match in re.finditer(_TOPIC, data):
                name = match[match.lastindex or 0].decode("utf-8", "replace").strip("/")
                is_called = (source.path, data.rfind(b"<", 0, match.start())) in called
                if name not in used and not is_called:
                    yield name


def _expanded_calls(elements: list[Element]) -> set[tuple[str, int]]:
    """Path and offset of the macro calls from which elements come."""
    innermost = {element.frame for element in elements if element.frame}
    return {
        (frame.call.source.path, frame.call.start)
        for inner in innermost
        for frame in inner.outwards()
    }

"""The program that puts the robot into Gazebo refuses its command line, or gets no robot.

The scripts stop at an option that they do not have: the name of the robot is `-entity` in
`spawn_entity.py` and `-model` in ROS 1's `spawn_model`. `create` of ros_gz_sim, which calls it
`-name`, passes over the others. All stop where the name or the source of the robot is missing. A
file that does not exist, or a xacro, which nobody expands there, gives no robot; on a misspelt
topic they wait for ever.

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    gazebo_ros, spawn_entity.py: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/scripts/spawn_entity.py
    gazebo_ros, spawn_model: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros/scripts/spawn_model
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.diagnostic import Severity
from urdfkit.launch.collect import UNKNOWN
from urdfkit.launch.found import Started, Word
from urdfkit.nearest import did_you_mean, nearest
from urdfkit.record import Record
from urdfkit.rules import Finding, Need, Written, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

NAME = "robot.launch.py"
BAD = """\
from launch_ros.actions import Node

spawn = Node(
    package="ros_gz_sim",
    executable="create",
    arguments=["-topic", "robot_description", "-entity", "arm"],
)
"""
GOOD = BAD.replace("-entity", "-name")


class _Spawner(Record):
    """A program that puts models into Gazebo.

    Attributes:
        valued, plain: its options with and without a value.
        required: groups of options, of each of which one must be there.
    """

    valued: frozenset[str]
    plain: frozenset[str]
    required: tuple[tuple[str, ...], ...]


_POSE = "x y z R P Y"
_CREATE = _Spawner(
    frozenset(f"world file param string topic name flagfile {_POSE}".split()),
    frozenset(("allow_renaming", "noallow_renaming", "stdin", "help")),
    (("file", "param", "string", "topic", "stdin"),),
)
_ENTITY = _Spawner(
    frozenset(
        "file topic database entity reference_frame gazebo_namespace robot_namespace timeout wait "
        f"spawn_service_timeout {_POSE}".split()
    ),
    frozenset("stdin unpause package_to_model b h help".split()),
    (("entity",), ("file", "topic", "database", "stdin")),
)
_MODEL = _Spawner(
    frozenset(
        "file param database model reference_frame gazebo_namespace robot_namespace wait J "
        f"{_POSE}".split()
    ),
    frozenset("urdf sdf stdin unpause package_to_model b h help".split()),
    (("model",), ("urdf", "sdf"), ("file", "param", "database", "stdin")),
)
_SPAWNERS = {
    ("ros_gz_sim", "create"): _CREATE,
    ("ros_ign_gazebo", "create"): _CREATE,
    ("gazebo_ros", "spawn_entity.py"): _ENTITY,
    ("gazebo_ros", "spawn_model"): _MODEL,
}
#: What the name of the robot is called elsewhere.
_NAMED = {
    "entity": "write -name for create, -model in ROS 1",
    "model": "write -name for create, -entity for spawn_entity.py",
    "name": "write -entity for spawn_entity.py, -model in ROS 1",
}
_NUMBER = re.compile(r"-[\d.]")
_TOPIC = "robot_description"


@rule("LAU016", "spawn-refused", Severity.ERROR, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Iterator[Finding]:
    for started in subject.launch.started:
        spawner = _SPAWNERS.get((started.package, started.executable))
        if spawner is None:
            continue
        given, is_known = _options(started, spawner)
        for option, word in given.items():
            place = Written(word.span, started.frame)
            known = spawner.valued | spawner.plain
            if option not in known:
                hint = did_you_mean(option, known)
                message = f"{started.executable} has no option '-{option}'{hint}"
                yield Finding(place, message, _NAMED.get(option, "remove it"))
            else:
                yield from _value(option, word, place)
        if is_known and started.words and not started.parameters:
            yield from _missing(started, spawner, given)


def _options(started: Started, spawner: _Spawner) -> tuple[dict[str, Word], bool]:
    """The options, with the words of their values; False if there may be others."""
    given: dict[str, Word] = {}
    is_known = True
    words = iter(started.words)
    for word in words:
        text = word.text
        if text is None or not text.startswith("-") or _NUMBER.match(text):
            is_known = is_known and text is not None
            continue
        if text.startswith("--ros-args"):
            break
        option, _, value = text.lstrip("-").partition("=")
        if spawner is _CREATE:
            option = option.replace("-", "_")  # gflags takes both
        given[option] = Word(value, word.span) if value else word
        if option in spawner.valued and not value:
            given[option] = next(words, word)
    return given, is_known


def _value(option: str, word: Word, place: Written) -> Iterator[Finding]:
    """What is wrong with the value of an option."""
    text = word.text or ""
    if option == "file" and text.endswith(".xacro"):
        message = f"'{os.path.basename(text)}' is a xacro, and Gazebo does not expand it"
        yield Finding(place, message, f"expand it for the topic {_TOPIC} and spawn that")
    elif option == "file" and os.path.isabs(text) and not text.startswith(f"{UNKNOWN}/"):
        if not os.path.exists(text):
            yield Finding(place, f"'{text}' does not exist", "make the file, or mend its name")
    elif option in ("topic", "param"):
        name = text.rpartition("/")[2]
        is_as_long = abs(len(name) - len(_TOPIC)) < 3
        if name != _TOPIC and is_as_long and nearest(name, [_TOPIC], 0.9):
            yield Finding(place, f"'{name}' is not '{_TOPIC}'", f"write {_TOPIC}")


def _missing(started: Started, spawner: _Spawner, given: dict[str, Word]) -> Iterator[Finding]:
    for group in spawner.required:
        if not any(option in given for option in group):
            options = " or ".join(f"-{option}" for option in group)
            message = f"{started.executable} needs {options}"
            yield Finding(Written(started.span, started.frame), message, f"write {options}")

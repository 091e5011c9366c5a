"""The program that puts the robot into Gazebo refuses its command line, or gets no robot.

The scripts of gazebo_ros stop at an option that they do not have: the name of the robot is
`-entity` in `spawn_entity.py`, and `-model` in ROS 1's `spawn_model`. They and `create` of
ros_gz_sim stop where something is missing that they need. A file that does not exist, or a xacro,
which nobody expands there, gives no robot; on a misspelt topic they wait for ever.

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    gazebo_ros, spawn_entity.py: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/scripts/spawn_entity.py
    gazebo_ros, spawn_model: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros/scripts/spawn_model
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import StartedProgram, Word
from urdfkit.ros.launch.spawning import SPAWNERS, Spawner, options
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

NAME = "robot.launch.py"
BAD = """\
from launch_ros.actions import Node

spawn = Node(
    package="gazebo_ros",
    executable="spawn_entity.py",
    arguments=["-topic", "robot_description", "-name", "arm"],
)
"""
GOOD = BAD.replace("-name", "-entity")


#: What the name of the robot is called elsewhere.
_NAMED = {
    "entity": "write -model in ROS 1",
    "model": "write -entity for spawn_entity.py",
    "name": "write -entity for spawn_entity.py, -model in ROS 1",
}
_TOPIC = "robot_description"


@rule("LAU016", "spawn-refused", Severity.ERROR, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Iterator[Finding]:
    for started in subject.launch.started:
        spawner = SPAWNERS.get((started.package, started.executable))
        if spawner is None:
            continue
        given, is_known = options(started, spawner)
        for option, word in given.items():
            place = Location(word.span, started.frame)
            if option not in spawner.known and spawner.is_strict:
                hint = did_you_mean(option, spawner.known)
                message = f"{started.executable} has no option '-{option}'{hint}"
                yield Finding(place, message, _NAMED.get(option, "remove it"))
            else:
                yield from _value(option, word, place)
        if is_known and started.words and not started.parameters:
            yield from _missing(started, spawner, given)


def _value(option: str, word: Word, place: Location) -> Iterator[Finding]:
    """What is wrong with the value of an option."""
    text = word.text or ""
    if option == "file" and text.endswith(".xacro"):
        message = f"'{os.path.basename(text)}' is a xacro, and Gazebo does not expand it"
        yield Finding(place, message, f"expand it for the topic {_TOPIC} and spawn that")
    elif option == "file" and os.path.isabs(text) and not text.startswith(f"{UNKNOWN}/"):
        if not os.path.exists(text):
            yield Finding(place, f"'{text}' does not exist", "create the file, or fix its name")
    elif option in ("topic", "param"):
        name = text.rpartition("/")[2]
        is_as_long = abs(len(name) - len(_TOPIC)) < 3
        if name != _TOPIC and is_as_long and nearest(name, [_TOPIC], 0.9):
            yield Finding(place, f"'{name}' is not '{_TOPIC}'", f"write {_TOPIC}")


def _missing(
    started: StartedProgram, spawner: Spawner, given: dict[str, Word]
) -> Iterator[Finding]:
    for group in spawner.required:
        if not any(option in given for option in group):
            wanted = " or ".join(f"-{option}" for option in group)
            message = f"{started.executable} needs {wanted}"
            yield Finding(Location(started.span, started.frame), message, f"write {wanted}")

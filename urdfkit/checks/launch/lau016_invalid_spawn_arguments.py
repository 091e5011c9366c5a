"""The node that spawns the robot in Gazebo has invalid arguments, or gets no robot.

The scripts of gazebo_ros stop at an unknown option: the name of the robot is `-entity` in
`spawn_entity.py`, and `-model` in ROS 1's `spawn_model`. `create` of ros_gz_sim, where it is
`-name`, ignores an unknown option with its value (warning). All stop where a required option is
missing. A file that does not exist, or a xacro, which is not expanded there, gives no robot; with a
misspelt topic they wait for ever. A missing file outside the workspace is a warning, as it may be
on the robot's computer, and one in `/tmp` is not reported: the launch file may write it.

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    gazebo_ros, spawn_entity.py: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/scripts/spawn_entity.py
    gazebo_ros, spawn_model: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros/scripts/spawn_model
"""

import os

from urdfkit.core import disk
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import StartedProgram, Word
from urdfkit.ros.launch.spawning import Spawner, options, spawner_of

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

#: The option for the name of the robot, in other programs.
_NAMED = {
    "entity": "write -model in ROS 1, -name for create",
    "model": "write -entity for spawn_entity.py, -name for create",
    "name": "write -entity for spawn_entity.py, -model in ROS 1",
}
_TOPIC = "robot_description"


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for started in context.launch.started:
        spawner = spawner_of(started)
        if spawner is None:
            continue
        given, is_known = options(started, spawner)
        for option, word in given.items():
            place = Location(word.span, started.frame)
            if option not in spawner.known:
                meant = nearest(option, spawner.known)
                hint = f"; did you mean '-{meant}'?" if meant else ""
                ignored = "" if spawner.is_strict else " (ignored)"
                yield Finding(
                    place,
                    f"{started.executable} has no option '-{option}'{ignored}{hint}",
                    _NAMED.get(option, f"write -{meant}" if meant else "remove it"),
                    severity=None if spawner.is_strict else Severity.WARNING,
                )
            else:
                yield from _value(context, option, word, place)
        if is_known and started.words and not started.parameters.values:
            yield from _missing(started, spawner, given)


def _value(context: Context, option: str, word: Word, place: Location) -> Findings:
    """The value of an option, if it is invalid."""
    text = word.text or ""
    if option == "file" and text.endswith(".xacro") and not _is_expanded(context, text):
        message = f"'{os.path.basename(text)}' is a xacro file, which Gazebo does not expand"
        yield Finding(place, message, f"publish the expanded robot on {_TOPIC} and spawn that")
    elif option == "string" and text.endswith((".urdf", ".xacro", ".sdf")):
        message = f"-string is the text of a robot, and '{os.path.basename(text)}' the path of one"
        yield Finding(place, message, f"spawn -topic {_TOPIC}, or an expanded -file")
    elif option == "file" and os.path.isabs(text) and not text.startswith(f"{UNKNOWN}/"):
        is_inside = context.resolver.allows(text, context.source.path)
        if not disk.exists(text) and (is_inside or not text.startswith("/tmp/")):
            yield Finding(
                place,
                f"file not found: {text}",
                "create the file, or fix its name",
                severity=None if is_inside else Severity.WARNING,
            )
    elif option in ("topic", "param"):
        name = text.rpartition("/")[2]
        is_as_long = abs(len(name) - len(_TOPIC)) < 3
        if name != _TOPIC and is_as_long and nearest(name, [_TOPIC], 0.9):
            message = f"unknown {option} '{name}'; did you mean '{_TOPIC}'?"
            yield Finding(place, message, f"write {_TOPIC}")


def _is_expanded(context: Context, path: str) -> bool:
    """True for a xacro file with nothing to expand."""
    if not disk.is_file(path) or not context.resolver.allows(path, context.source.path):
        return False
    data = context.resolver.read(path).data
    return not any(mark in data for mark in (b"<xacro:", b"${", b"$("))


def _missing(started: StartedProgram, spawner: Spawner, given: dict[str, Word]) -> Findings:
    for group in spawner.required:
        if not any(option in given for option in group):
            required = " or ".join(f"-{option}" for option in group)
            message = f"{started.executable} requires {required}"
            yield Finding(Location(started.span, started.frame), message, f"add {required}")

"""The node that spawns the robot in Gazebo has invalid arguments, or gets no robot.

- An unknown option stops `spawn_entity.py` and ROS 1's `spawn_model` of gazebo_ros; `create` of
  ros_gz_sim ignores it with its value (warning). The name of the robot is `-entity`, `-model` and
  `-name`, respectively.
- A required option is missing: the program stops.
- The file does not exist, or is a xacro file, which is not expanded. A missing file outside the
  workspace is a warning: the robot may have it. A file in `/tmp` is not reported, nor one that
  git ignores, which a build makes, or that another command of the launch file names.
- The topic is misspelt: the program waits for ever. A name with a digit, or that the launch file
  has more than once, is the name of another robot.

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
    gazebo_ros, spawn_entity.py: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/scripts/spawn_entity.py
    gazebo_ros, spawn_model: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros/scripts/spawn_model
"""

import os
import re

from urdfkit.core import disk
from urdfkit.core.suggest import CLOSE_TYPO, nearest, nearest_file
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import StartedProgram, Word
from urdfkit.ros.launch.spawning import ModelSpawner, model_spawner, options
from urdfkit.workspace.gitignore import is_ignored

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

#: Help for the options of other programs for the name of the robot.
_NAMED = {
    "entity": "write -model in ROS 1, -name for create",
    "model": "write -entity for spawn_entity.py, -name for create",
    "name": "write -entity for spawn_entity.py, -model in ROS 1",
}
_TOPIC = "robot_description"


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    for program in context.launch.started:
        spawner = model_spawner(program)
        if spawner is None:
            continue
        arguments, is_known = options(program, spawner)
        for option, word in arguments.items():
            place = Location(word.span, program.frame)
            if option not in spawner.known:
                suggested = nearest(option, spawner.known)
                hint = f"; did you mean '-{suggested}'?" if suggested else ""
                ignored = "" if spawner.is_strict else " (ignored)"
                yield Finding(
                    place,
                    f"{program.executable} has no option '-{option}'{ignored}{hint}",
                    _NAMED.get(option, f"write -{suggested}" if suggested else "remove it"),
                    severity=None if spawner.is_strict else Severity.WARNING,
                )
            else:
                yield from _value(context, option, word, place)
        given = program.parameters
        if is_known and not given.values and (program.words or given.every is not None):
            yield from _missing(program, spawner, arguments)


def _value(context: Context, option: str, word: Word, place: Location) -> Findings:
    """The invalid value of an option."""
    text = word.text or ""
    if option == "file":
        yield from _file(context, text, place)
    elif option == "string" and text.endswith((".urdf", ".xacro", ".sdf")):
        message = f"-string takes the text of a robot, but '{os.path.basename(text)}' is a path"
        yield Finding(place, message, f"spawn -topic {_TOPIC}, or an expanded -file")
    elif option in ("topic", "param"):
        name = text.rpartition("/")[2]
        is_as_long = abs(len(name) - len(_TOPIC)) < 3
        is_similar = is_as_long and nearest(name, [_TOPIC], CLOSE_TYPO)
        if name != _TOPIC and is_similar and not _is_meant(name, place):
            message = f"unknown {option} '{name}'; did you mean '{_TOPIC}'?"
            yield Finding(place, message, f"write {_TOPIC}")


def _is_meant(name: str, place: Location) -> bool:
    """True for the name of another robot: with a digit, or more than once in the launch file."""
    text = place.span.source.data.decode(errors="replace")
    return any(map(str.isdigit, name)) or len(re.findall(rf"\b{re.escape(name)}\b", text)) > 1


def _file(context: Context, path: str, place: Location) -> Findings:
    if path.endswith(".xacro") and not _is_expanded(context, path):
        message = f"'{os.path.basename(path)}' is a xacro file, which Gazebo does not expand"
        yield Finding(place, message, f"publish the expanded robot on {_TOPIC} and spawn that")
    elif (
        os.path.isabs(path)
        and not path.startswith(f"{UNKNOWN}/")
        and not disk.exists(path)
        and not context.resolver.installed(path)
    ):
        is_inside = context.resolver.allows(path, context.source.path)
        is_made = is_ignored(path) if is_inside else path.startswith("/tmp/")
        if not is_made and not _is_mentioned(context, path):
            suggested = nearest_file(path) if is_inside else None
            help = (
                f"did you mean '{suggested}'?" if suggested else "create the file, or fix its name"
            )
            severity = None if is_inside else Severity.WARNING
            yield Finding(place, f"file not found: {path}", help, severity=severity)


def _is_mentioned(context: Context, path: str) -> bool:
    """True if a program of the launch file, not a node, has a path: it probably writes the file."""
    programs = (program for program in context.launch.started if not program.package)
    return any(path in (word.text or "") for program in programs for word in program.words)


def _is_expanded(context: Context, path: str) -> bool:
    """True for a xacro file with nothing to expand."""
    if not disk.is_file(path) or not context.resolver.allows(path, context.source.path):
        return False
    data = context.resolver.read(path).data
    return not any(mark in data for mark in (b"<xacro:", b"${", b"$("))


def _missing(
    program: StartedProgram, spawner: ModelSpawner, arguments: dict[str, Word]
) -> Findings:
    for group in spawner.required:
        if not any(option in arguments for option in group):
            required = " or ".join(f"-{option}" for option in group)
            message = f"{program.executable} requires {required}"
            yield Finding(program.at, message, f"add {required}")

"""The program that puts the robot into Gazebo passes over an option that it does not have.

`create` of ros_gz_sim takes it without a word, and the value is lost. The name of the robot is
`-name` there; `-entity` and `-model` belong to the scripts of gazebo_ros.

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.launch.spawning import SPAWNERS, options
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

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


@rule("LAU018", "spawn-option-ignored", Severity.WARNING, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Iterator[Finding]:
    for started in subject.launch.started:
        spawner = SPAWNERS.get((started.package, started.executable))
        if spawner is None or spawner.is_strict:
            continue
        for option, word in options(started, spawner)[0].items():
            if option not in spawner.known:
                is_name = option in ("entity", "model")
                yield Finding(
                    Location(word.span, started.frame),
                    f"{started.executable} passes over '-{option}'"
                    + did_you_mean(option, spawner.known),
                    "write -name" if is_name else "remove it",
                )

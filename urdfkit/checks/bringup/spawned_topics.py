"""What the robots publish in ROS that launch files spawn in Gazebo Classic."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.lint.rules import Context
from urdfkit.ros.gazebo.classic_topics import ClassicTopic, classic_topics
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.spawning import spawn_option
from urdfkit.text.source import Span

#: The topics of the robot that a program spawns, by its place; only if all are known.
SpawnedTopics = Mapping[Span, list[ClassicTopic]]

_SPAWNER = "gazebo_ros/spawn_entity.py"


def spawned_topics(context: Context, launches: tuple[Launch, ...]) -> SpawnedTopics:
    found: dict[Span, list[ClassicTopic]] = {}
    for launch in launches:
        for program in launch.programs:
            is_spawner = program.key == _SPAWNER
            topics = _topics(context, launch, program) if is_spawner else None
            if topics is not None:
                found[program.span] = topics
    return found


def _topics(context: Context, launch: Launch, program: StartedProgram) -> list[ClassicTopic] | None:
    """The topics of the robot of a launch file, if it is spawned from a topic."""
    space = spawn_option(program, "robot_namespace")
    is_known = program.is_sure and (space is None or space.text is not None)
    if not is_known or spawn_option(program, "topic") is None or len(launch.descriptions) != 1:
        return None
    description = launch.descriptions[0]
    robot = context.other_robot(description.path, description.arguments)
    if robot.reading.document is None or not description.is_whole:
        return None
    return classic_topics(robot.plugins, (space.text or "") if space else "")

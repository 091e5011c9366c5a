"""A node spawns the robot into, or forwards topics of, another world than the started one.

- The node that spawns the robot names another world: it waits for the service of that world for
  ever.
- The bridge forwards a topic of another world, on which nothing is published (warning: it may be
  that of another world file, which an argument of the launch file selects).

Sources:
    ros_gz_sim, create.cpp: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/src/create.cpp
"""

import re

from urdfkit.checks.worlds.opened_worlds import OpenedWorld, opened_worlds
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.spawning import model_spawner, options
from urdfkit.ros.launch.worlds import GZ, worlds
from urdfkit.text.source import Span

NAME = "launch/robot.launch.py"
BAD = """\
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

actions = [
    ExecuteProcess(cmd=["gz", "sim", "-r", "empty.sdf"]),
    Node(package="ros_gz_sim", executable="create",
         arguments=["-world", "hall", "-topic", "robot_description"]),
]
"""
GOOD = BAD.replace('"hall"', '"empty"')

#: Topics of a world, with its name.
_OF_WORLD = re.compile(r"/?world/([^/]+)(?=/)")


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    started = list(opened_worlds(context))
    if len(started) == len({world.span for world in worlds(context.launch)}) == 1:
        yield from _other_worlds(context, started[0])


def _other_worlds(context: Context, opened: OpenedWorld) -> Findings:
    """Nodes that spawn the robot into a world of another name, or forward its topics."""
    if opened.started.generation != GZ or not opened.name or not opened.started.is_sure:
        return
    for program in context.launch.programs:
        spawner = model_spawner(program)
        word = options(program, spawner)[0].get("world") if spawner else None
        name = word.text if word else program.parameters.values.get("world")
        if spawner and not spawner.is_strict and name and name != opened.name:
            span: Span = word.span if word else program.span
            yield Finding(
                Location(span, program.frame),
                f"the robot is spawned into world '{name}', but world '{opened.name}' is started",
                f"write {opened.name}, or omit the name",
            )
        for topic in bridged_topics(program, context.resolver):
            match = _OF_WORLD.match(topic.topic)
            if match and match.group(1) != opened.name:
                help = f"write /world/{opened.name}{topic.topic[match.end(1) :]}"
                if topic.places:  # other launch files, which start that world, may use the file
                    help = f"name the started world '{match.group(1)}', too; or {help}"
                yield Finding(
                    Location(topic.at("gz_topic_name", "topic_name"), program.frame),
                    f"the bridge has '{topic.topic}' of world '{match.group(1)}', but world "
                    f"'{opened.name}' is started",
                    help,
                    severity=Severity.WARNING,
                )

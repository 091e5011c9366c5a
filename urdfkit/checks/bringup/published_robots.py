"""The robots whose transforms robot_state_publisher publishes next to a launch file."""

from __future__ import annotations

import re

from urdfkit.checks.bringup.workspace_launches import (
    distinct_descriptions,
    programs_of,
    workspace_launches,
)
from urdfkit.lint.rules import Context
from urdfkit.ros.launch.collect import SIM_TIME
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.spawning import model_spawner

PUBLISHER = "robot_state_publisher"
#: Packages whose nodes need the transforms of a robot that is running.
_NEEDING = re.compile(r"nav2_\w+|slam_toolbox|robot_localization")
_RVIZ = frozenset(("rviz", "rviz2"))
#: Packages of the programs that show a model.
_OF_DISPLAY = _RVIZ | {PUBLISHER, "joint_state_publisher", "joint_state_publisher_gui"}


def published_robots(context: Context) -> list[Context]:
    """The robots of a launch file; if it starts only navigation, those of the workspace.

    Returns:
        An empty list if a robot is unknown, or may have other names of frames.
    """
    launches: tuple[Launch, ...] = (context.launch,)
    if not any(map(_is_publisher, context.launch.programs)):
        if not any(_NEEDING.fullmatch(node.package) for node in context.launch.programs):
            return []
        launches = workspace_launches(context)
    publishing = _publishing(launches)
    publishers = filter(_is_publisher, programs_of(publishing))
    descriptions = distinct_descriptions(publishing)
    are_whole = all(description.is_whole for description in descriptions)
    if not are_whole or not all(map(_is_plain, publishers)):
        return []
    robots = [robot for _, robot in context.expanded(descriptions)]
    return robots if len(robots) == len(descriptions) else []


def runs_in_simulation_only(context: Context) -> bool:
    """True if only launch files of a simulation start the publisher, and this is of none.

    A launch file for the real robot publishes the transforms that are joints of the simulated one.
    """
    own = context.launch.programs
    if any(map(_is_publisher, own)) or any(map(_has_sim_time, own)):
        return False
    launches = _publishing(workspace_launches(context))
    return all(any(map(model_spawner, file.programs)) for file in launches)


def runs_in_display_only(context: Context) -> bool:
    """True if only launch files that show the model in RViz start the publisher, and this is none.

    A launch file with static transforms in place of the joints works without the publisher.
    """
    if any(map(_is_publisher, context.launch.programs)):
        return False
    return all(
        {program.package for program in file.programs} <= _OF_DISPLAY
        and any(program.package in _RVIZ for program in file.programs)
        for file in _publishing(workspace_launches(context))
    )


def _publishing(launches: tuple[Launch, ...]) -> list[Launch]:
    """The launch files that start robot_state_publisher."""
    return [launch for launch in launches if any(map(_is_publisher, launch.programs))]


def _has_sim_time(started: StartedProgram) -> bool:
    return (started.parameters.values.get(SIM_TIME) or "").lower() == "true"


def _is_publisher(started: StartedProgram) -> bool:
    return started.package == PUBLISHER


def _is_plain(started: StartedProgram) -> bool:
    """True for a publisher that does not rename the frames."""
    return started.namespace == "" and "frame_prefix" not in started.parameters.values

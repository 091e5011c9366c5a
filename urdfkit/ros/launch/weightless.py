"""Robots that launch files start in weightlessness."""

from urdfkit.core import disk
from urdfkit.errors import UnreadableFile
from urdfkit.ros.gazebo.worlds import World, read_world
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.ros.launch.worlds import StartedWorld, world_file, worlds
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


def is_started_weightless(robot: Source, resolver: Resolver) -> bool:
    """True if launch files start a robot in worlds of Gazebo without gravity, and in no other."""
    real = disk.real(robot.path)
    launches = [
        launch
        for launch in launches_of_workspace(robot.path, resolver)
        if any(disk.real(robot.path) == real for robot in launch.descriptions)
    ]
    started = [world for launch in launches for world in worlds(launch)]
    opened = [_opened(world, robot.path, resolver) for world in started]
    return bool(opened) and all(world is not None and world.is_weightless for world in opened)


def _opened(started: StartedWorld, near: str, resolver: Resolver) -> World | None:
    path = world_file(started.name, near, resolver) if started.name else None
    try:
        return read_world(path, resolver)[0] if path else None
    except UnreadableFile:
        return None

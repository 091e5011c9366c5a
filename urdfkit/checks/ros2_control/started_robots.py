"""Robots that launch files start, and that share a parameter file with the checked one."""

import os
from collections.abc import Collection

from urdfkit.core import disk
from urdfkit.lint.rules import Context
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.ros.launch.spawned_controllers import spawned_controllers


def started_robot_of(path: str, joints: Collection[str], context: Context) -> str:
    """The started robot that names a parameter file and has the joints; empty if there is none.

    Empty, too, if launch files start the checked robot.
    """
    launches = launches_of_workspace(context.source.path, context.resolver)
    started = {disk.real(robot.path) for launch in launches for robot in launch.descriptions}
    if disk.real(context.source.path) in started:
        return ""
    name = os.path.basename(path).encode()
    for file in sorted(started):
        source = context.resolver.readable(file)
        if source and name in source.data:
            robot = context.other_robot(file, {})
            if _has(robot, joints) and _names(robot, path):
                return file
    return ""


def is_of_other_robot(
    controller: str, joints: Collection[str], path: str, context: Context
) -> bool:
    """True if launch files load a parameter file for another robot, which has all the joints.

    They must start the checked robot, too, without the controller.
    """
    path, checked = disk.real(path), disk.real(context.source.path)
    is_started = has_joints = False
    for launch in launches_of_workspace(context.source.path, context.resolver):
        robots = {disk.real(robot.path): robot for robot in launch.descriptions}
        if checked in robots:
            is_started = True
            if any(found.name == controller for found in spawned_controllers(launch.programs)):
                return False
        elif not has_joints and path in {disk.real(file.path) for file in launch.parameters}:
            has_joints = any(
                context.resolver.readable(robot.path)
                and _has(context.other_robot(robot.path, robot.arguments), joints)
                for robot in robots.values()
            )
    return is_started and has_joints


def is_spawned_without(controller: str, joints: Collection[str], context: Context) -> bool:
    """True if launch files start a controller with the checked robot, which has other joints there.

    Only what certainly runs counts, and only a robot whose arguments are all known.
    """
    checked, is_started = disk.real(context.source.path), False
    for launch in launches_of_workspace(context.source.path, context.resolver):
        running = [program for program in launch.programs if program.is_sure]
        if not any(found.name == controller for found in spawned_controllers(running)):
            continue
        for robot in launch.descriptions:
            if robot.unknown or disk.real(robot.path) != checked:
                return False
            started = context.other_robot(robot.path, robot.arguments)
            if not started.is_readable:
                return False
            if not started.model.joints_by_name.keys().isdisjoint(joints):
                return False
            is_started = True
    return is_started


def _has(robot: Context, joints: Collection[str]) -> bool:
    return robot.is_readable and robot.model.joints_by_name.keys() >= set(joints)


def _names(robot: Context, path: str) -> bool:
    """True for a robot that names a parameter file."""
    return disk.real(path) in {disk.real(file.path) for file, _ in robot.controllers}

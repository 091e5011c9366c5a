"""Robots that launch files start, and that share a parameter file with the checked one."""

import os
from collections.abc import Collection

from urdfkit.core import disk
from urdfkit.lint.rules import Context
from urdfkit.ros.launch.robot_arguments import launches_of_workspace


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
            if robot.is_readable and _fits(robot, path, joints):
                return file
    return ""


def _fits(robot: Context, path: str, joints: Collection[str]) -> bool:
    """True for a robot that names a parameter file and has the joints."""
    files = {disk.real(file.path) for file, _ in robot.controllers}
    return disk.real(path) in files and all(joint in robot.model.joints_by_name for joint in joints)

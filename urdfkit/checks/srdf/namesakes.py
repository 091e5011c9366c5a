"""Other robots with the same name that an SRDF and MoveIt's files may have been written for."""

import os
from collections.abc import Iterator
from itertools import chain, islice

from urdfkit.core import disk
from urdfkit.lint.rules import Context
from urdfkit.ros.launch.contents import LaunchedDescription
from urdfkit.ros.launch.robot_arguments import launches_of_package, launches_of_workspace
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.text.file_kinds import is_xacro
from urdfkit.workspace.srdf_files import has_robot_name

#: Most robots of launch files that are expanded.
_MAX_STARTED = 32
#: Most files next to an SRDF or a robot that may be robots of its name.
_MAX_FILES = 60


def launched_namesakes(context: Context, srdf: Srdf) -> Iterator[Context]:
    """The robots with the name of a robot or its SRDF in launch files of the workspace.

    They are this robot with other arguments, or another revision of it.
    """
    names = context.model.name, srdf.root.get("name")
    for robot in _launched(context, srdf):
        name = context.name_of_robot(robot.path, robot.arguments)
        if name is not None and name in names:
            yield context.other_robot(robot.path, robot.arguments)


def _launched(context: Context, srdf: Srdf) -> Iterator[LaunchedDescription]:
    """The robots of the launch files of the workspace, also those that MoveIt's builder reads."""
    place = (srdf.path, context.resolver)
    launches = chain(launches_of_package(*place), launches_of_workspace(*place))
    descriptions = (
        description
        for launch in launches
        for description in (*launch.descriptions, *(robot for robot, _ in launch.built))
    )
    yield from islice(descriptions, _MAX_STARTED)


def _namesakes(context: Context, srdf: Srdf) -> Iterator[Context]:
    """Those of launch files, and those in files next to the SRDF or to the robot.

    The SRDF of a MoveIt configuration is for the xacro in there, and that of an arm for the one of
    its URDFs that has its tool.
    """
    yield from launched_namesakes(context, srdf)
    own, name = os.path.abspath(context.source.path), srdf.root.get("name") or ""
    for directory in dict.fromkeys(map(os.path.dirname, (own, os.path.abspath(srdf.path)))):
        files = sorted(context.resolver.directories.entries(directory) or ())[:_MAX_FILES]
        for path in (os.path.join(directory, file) for file in files):
            if path != own and has_robot_name(path, name):
                robot = context.other_robot(path, {})
                if robot.is_readable:
                    yield robot


def names_in_namesakes(context: Context, srdf: Srdf) -> set[str]:
    """Links and joints of other robots of the same name."""
    models = (robot.model for robot in _namesakes(context, srdf))
    return {name for model in models for name in (*model.links_by_name, *model.joints_by_name)}


def has_incomplete_namesake(context: Context, srdf: Srdf) -> bool:
    """True if the SRDF may be for a robot that lacks a package.

    That is a xacro with other arguments, or for a URDF the xacro next to it of the SRDF's name.
    """
    own = disk.real(context.source.path)
    directory, name = os.path.dirname(own), srdf.root.get("name") or ""
    if not srdf.unknown:
        return False
    if is_xacro(context.source):
        robots = (one for one in _launched(context, srdf) if disk.real(one.path) == own)
        return any(_lacks_package(context.other_robot(one.path, one.arguments)) for one in robots)
    names = context.resolver.directories.entries(directory) or () if name else ()
    xacros = (os.path.join(directory, file) for file in names if file.endswith(".xacro"))
    namesakes = (path for path in xacros if has_robot_name(path, name))
    return any(_lacks_package(context.other_robot(path, {})) for path in namesakes)


def _lacks_package(robot: Context) -> bool:
    return any(problem.code == "XAC011" for problem in robot.reading.problems)

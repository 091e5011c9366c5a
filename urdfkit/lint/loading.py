"""read(), load() and expand(): read one description without running rules."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING

from urdfkit.errors import UnreadableRobot
from urdfkit.lint.argument_sets import as_launched
from urdfkit.lint.context import Context
from urdfkit.lint.plan import Job
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.robot.model import RobotModel
    from urdfkit.ros.targets import Targets
    from urdfkit.text.diagnostic import Problem
    from urdfkit.text.document import Element
    from urdfkit.xacro import Xacro


def read(
    file: str | os.PathLike[str] | Source,
    *,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
    cache: bool = True,
    progress: Progress | None = None,
) -> Context:
    """Read a URDF or xacro file; the parts of the result are computed when they are first used.

    >>> robot = read("models/good/two_link_arm/urdf/two_link_arm.urdf")
    >>> [root.name for root in robot.tree.roots]
    ['mount']

    Args:
        file: URDF or xacro; the format is detected from the content.
        arguments: xacro arguments, like ``name:=value`` on the command line.
        packages: directories of ROS packages by name; they override every search.
        trust: do not sandbox the expressions of the model, and let it read any file.
        cache: cache the measures of mesh files for the next run.
        progress: called with the number of mesh files read and the number of all mesh files.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: the file is not XML, or does not expand; lists every reason.
    """
    source, resolver = Source.of(file), Resolver(packages)
    context = context_of(source, resolver, arguments, trust=trust, cache=cache, progress=progress)
    if context.reading.document is None:
        raise _unreadable(context.source, context.reading.problems)
    return context


def context_of(
    source: Source,
    resolver: Resolver,
    arguments: Mapping[str, str] | None,
    *,
    trust: bool = False,
    cache: bool = False,
    targets: Targets | None = None,
    progress: Progress | None = None,
) -> Context:
    """The robot of a file; missing arguments get the values that ``check`` finds.

    If ``check`` finds several sets of values, missing arguments stay without a value.

    Raises:
        UnreadableRobot: the file is a launch file that describes no robot, or more than one.
    """
    values = dict(arguments or {})
    if is_launch(source.path):
        source, values = _described(source, resolver, values)

    def described(job: Job) -> Context:
        return Context(
            source,
            resolver,
            job.arguments,
            trust=trust,
            cache=cache,
            targets=targets,
            progress=progress,
        )

    (job, context), *others = as_launched(Job(source.path, "", values, False), described)
    if others:
        return described(Job(source.path, "", values, False))
    context.launched = job.launched
    return context


def load(
    file: str | os.PathLike[str] | Source,
    *,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
) -> RobotModel:
    """Load the robot in a URDF or xacro file; every value has its source location.

    >>> robot = load("models/good/mobile_base/urdf/mobile_base.urdf.xacro")
    >>> robot.name, len(robot.links), robot.degrees_of_freedom
    ('mobile_base', 5, 2)
    >>> wheel = robot.joints_by_name["left_wheel_joint"]
    >>> print(wheel.limit.effort.value, "N·m, written at", wheel.limit.effort.span)
    5.0 N·m, written at models/good/mobile_base/urdf/mobile_base.urdf.xacro:52:22

    Lengths are in m, angles in rad, masses in kg. Values that cannot be read are None;
    ``urdfkit.check`` reports the reason.

    Args:
        file: URDF or xacro; the format is detected from the content.
        arguments: xacro arguments, like ``name:=value`` on the command line.
        packages: directories of ROS packages by name; they override every search.
        trust: do not sandbox the expressions of the model, and let it read any file.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: the file is not XML, does not expand, or is not a robot; lists every
            reason.
    """
    context = read(file, arguments=arguments, packages=packages, trust=trust)
    require_robot(context)
    return context.model


def require_robot(context: Context) -> None:
    """Reject a file that is not a robot description, such as an SDF, mesh or world file.

    Raises:
        UnreadableRobot: the file cannot be read, or the root element is not ``<robot>`` and there
            is no link.
    """
    if context.reading.document is None:
        raise _unreadable(context.source, context.reading.problems)
    if not context.model.links:
        require_robot_root(context.document.root, context.source.path)


def require_robot_root(root: Element, path: str) -> None:
    """Reject a document that is not a robot description.

    Raises:
        UnreadableRobot: the root element is not ``<robot>``.
    """
    if root.tag == "robot":
        return
    hint = ""
    if root.tag == "sdf" and root.child("world"):
        hint = "; a world is checked with the package that starts it: urdfkit check PACKAGE"
    raise UnreadableRobot(f"{path}: the root element is <{root.tag}>, not <robot>{hint}")


def expand(
    file: str | os.PathLike[str] | Source,
    *,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
) -> Xacro:
    """Expand a xacro file like the ``xacro`` command, without ROS.

    >>> xacro = expand("models/good/mobile_base/urdf/mobile_base.urdf.xacro")
    >>> xacro.text().count("<link")
    5
    >>> [macro.name for macro in xacro.macros]
    ['box_inertial', 'cylinder_inertial', 'sphere_inertial', 'shape', 'driven_wheel']

    Args:
        file: the xacro file.
        arguments: xacro arguments, like ``name:=value`` on the command line.
        packages: directories of ROS packages by name; they override every search.
        trust: do not sandbox the expressions of the model, and let it read any file.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: the file does not expand; lists every reason.
    """
    from urdfkit.xacro import expand as expand_source

    source = Source.of(file)
    xacro = expand_source(source, Resolver(packages), arguments, trust=trust)
    if xacro.document is None:
        raise _unreadable(source, xacro.problems)
    return xacro


def _described(
    source: Source, resolver: Resolver, arguments: dict[str, str]
) -> tuple[Source, dict[str, str]]:
    """The robot that a launch file describes, and its xacro arguments.

    Raises:
        UnreadableRobot: the launch file describes no robot, or more than one.
    """
    from urdfkit.ros.launch import read_launch

    robots = [(d.path, d.arguments) for d in read_launch(source, resolver, arguments).descriptions]
    if not robots:
        raise UnreadableRobot(
            f"{source.path} is a launch file and describes no robot that can be known without "
            "running it; pass the robot file"
        )
    path, values = robots[0]
    if any(robot != robots[0] for robot in robots):
        names = ", ".join(dict.fromkeys(path for path, _ in robots))
        raise UnreadableRobot(f"{source.path} describes several robots; pass one of {names}")
    return resolver.read(path), values


def _unreadable(source: Source, problems: Iterable[Problem]) -> UnreadableRobot:
    reasons = tuple(dict.fromkeys(f"{p.span}: {p.message}" for p in problems))
    no_robot = f"{source.path} is a parameter file and describes no robot; pass the robot file"
    text = "; ".join(reasons) or no_robot
    return UnreadableRobot(text, tuple(problems))

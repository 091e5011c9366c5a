"""read(), load() and expand(): one description, without any rule."""

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
    """A URDF or xacro file with all that can be computed of it, each part when it is asked for.

    >>> robot = read("models/good/two_link_arm/urdf/two_link_arm.urdf")
    >>> [root.name for root in robot.tree.roots]
    ['mount']

    Args:
        file: URDF or xacro; which of the two is decided by content.
        arguments: xacro arguments, as ``name:=value`` gives them on the command line.
        packages: directories of ROS packages by name; they win over every search.
        trust: do not sandbox the expressions of the model, and let it read any file.
        cache: keep what is measured of mesh files for the next run.
        progress: called with the number of mesh files read and of all, when they are asked for.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: it is not XML, or does not expand; with every reason.
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
    """The one robot of a file, with values for arguments that it lacks as ``check`` finds them.

    Where several sets of values are found, it is left as it is.

    Raises:
        UnreadableRobot: the file is a launch file that describes no robot, or more than one.
    """
    given = dict(arguments or {})
    if is_launch(source.path):
        source, given = _described(source, resolver, given)

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

    (job, context), *others = as_launched(Job(source.path, "", given, False), described)
    if others:
        return described(Job(source.path, "", given, False))
    context.launched = job.launched
    return context


def load(
    file: str | os.PathLike[str] | Source,
    *,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
) -> RobotModel:
    """The robot in a URDF or xacro file; every value knows its place in the file.

    >>> robot = load("models/good/mobile_base/urdf/mobile_base.urdf.xacro")
    >>> robot.name, len(robot.links), robot.degrees_of_freedom
    ('mobile_base', 5, 2)
    >>> wheel = robot.joints_by_name["left_wheel_joint"]
    >>> print(wheel.limit.effort.value, "N·m, written at", wheel.limit.effort.span)
    5.0 N·m, written at models/good/mobile_base/urdf/mobile_base.urdf.xacro:52:22

    Lengths are in m, angles in rad, masses in kg. Values that cannot be read are None;
    ``urdfkit.check`` says why.

    Args:
        file: URDF or xacro; which of the two is decided by content.
        arguments: xacro arguments, as ``name:=value`` gives them on the command line.
        packages: directories of ROS packages by name; they win over every search.
        trust: do not sandbox the expressions of the model, and let it read any file.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: it is not XML, does not expand, or is no robot; with every reason.
    """
    context = read(file, arguments=arguments, packages=packages, trust=trust)
    require_robot(context)
    return context.model


def require_robot(context: Context) -> None:
    """See that a file is a description of a robot, and no SDF, mesh or world.

    Raises:
        UnreadableRobot: its root is another, and there is no link.
    """
    root = context.document.root
    if context.model.links or root.tag == "robot":
        return
    hint = ""
    if root.tag == "sdf" and root.child("world"):
        hint = "; a world is checked with the package that starts it: urdfkit check PACKAGE"
    where = f"{context.source.path}: the root element is <{root.tag}>, not <robot>"
    raise UnreadableRobot(where + hint)


def expand(
    file: str | os.PathLike[str] | Source,
    *,
    arguments: Mapping[str, str] | None = None,
    packages: Mapping[str, str] | None = None,
    trust: bool = False,
) -> Xacro:
    """A xacro file expanded as the ``xacro`` command does, without ROS.

    >>> xacro = expand("models/good/mobile_base/urdf/mobile_base.urdf.xacro")
    >>> xacro.text().count("<link")
    5
    >>> [macro.name for macro in xacro.macros]
    ['box_inertial', 'cylinder_inertial', 'sphere_inertial', 'shape', 'driven_wheel']

    Args:
        file: the xacro file.
        arguments: as ``name:=value`` gives them on the command line.
        packages: directories of ROS packages by name; they win over every search.
        trust: do not sandbox the expressions of the model, and let it read any file.

    Raises:
        UnreadableFile: the file is missing or may not be read.
        UnreadableRobot: it does not expand; with every reason.
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
        UnreadableRobot: it describes none, or more than one.
    """
    from urdfkit.ros.launch import read_launch

    found = [(d.path, d.arguments) for d in read_launch(source, resolver, arguments).descriptions]
    if not found:
        raise UnreadableRobot(
            f"{source.path} is a launch file and describes no robot that can be known without "
            "running it; pass the robot file"
        )
    path, given = found[0]
    if any(other != found[0] for other in found):
        names = ", ".join(dict.fromkeys(path for path, _ in found))
        raise UnreadableRobot(f"{source.path} describes several robots; pass one of {names}")
    return resolver.read(path), given


def _unreadable(source: Source, problems: Iterable[Problem]) -> UnreadableRobot:
    reasons = tuple(dict.fromkeys(f"{p.span}: {p.message}" for p in problems))
    text = "; ".join(reasons) or f"{source.path}: no robot"
    return UnreadableRobot(text, tuple(problems))

"""The sets of arguments with which launch files start a description."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.plan import Job
from urdfkit.lint.report import Launched
from urdfkit.workspace.launch_files import has_launch_files

if TYPE_CHECKING:
    from urdfkit.lint.context import Context
    from urdfkit.ros.launch.robot_arguments import RobotArguments


def launch_sets(job: Job, names: tuple[str, ...], context: Context) -> list[RobotArguments]:
    """The distinct sets of arguments in launch files; sets with new values are first.

    Args:
        names: names of the missing arguments; sets without all of them are omitted.
    """
    sets: dict[object, RobotArguments] = {}
    for robot in (*_passed(job, names, context), *job.launch_sets):
        if robot.arguments.keys() >= set(names):
            files = (file.path for file in robot.parameters)
            key = (frozenset(robot.arguments.items()), *files)
            if key not in sets or (robot.is_whole and not sets[key].is_whole):
                sets[key] = robot
    known: set[tuple[str, str]] = set()
    new: list[RobotArguments] = []
    rest: list[RobotArguments] = []
    for robot in sets.values():
        (rest if robot.arguments.items() <= known else new).append(robot)
        known.update(robot.arguments.items())
    return new + rest


def _passed(job: Job, names: tuple[str, ...], context: Context) -> list[RobotArguments]:
    if (job.frame and not names) or not has_launch_files(job.path, context.resolver):
        return []
    from urdfkit.ros.launch.robot_arguments import passed_arguments  # for robots with launch files

    reading = context.reading
    return passed_arguments(
        job.path,
        names,
        context.resolver,
        only_parameters=reading.document is not None and not reading.defaults,
        wanted=reading.early_arguments,
    )


def variants(
    job: Job, sets: Iterable[RobotArguments], names: Iterable[str] | None = None
) -> Iterator[Job]:
    """A job with each of the sets of arguments of launch files.

    Args:
        names: names of the arguments whose origin is reported; all if None.
    """
    known: list[dict[str, str]] = []
    for robot in sets:
        reported = robot.arguments if names is None else names
        origins = {name: (robot.arguments[name], robot.launch) for name in reported}
        variant = job._replace(
            frame=robot.frame,
            arguments={**robot.arguments, **job.arguments},
            parameters=robot.parameters,
            launch_sets=(),
            launched=by_origin(job, origins),
            may_fail=job.may_fail if robot.frame is None else not robot.is_whole,
            assumed="" if robot.frame else as_text(robot.arguments),
            unknown=robot.unknown,
        )
        yield variant.about_parameters() if variant.arguments in known else variant
        known.append(variant.arguments)


def by_origin(job: Job, values: Mapping[str, tuple[str, str]]) -> tuple[Launched, ...]:
    """The values of arguments, grouped by origin."""
    origins: dict[str, dict[str, str]] = {}
    for name, (value, origin) in values.items():
        origins.setdefault(origin, {})[name] = value
    return tuple(Launched(job.path, *item) for item in origins.items())


def as_text(arguments: Mapping[str, str]) -> str:
    return ", ".join(f"{name}={value}" for name, value in arguments.items())

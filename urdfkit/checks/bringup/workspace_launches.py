"""The launch files of the workspace, and their programs."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfkit.lint.rules import Context
from urdfkit.ros.launch import argument_checks
from urdfkit.ros.launch.contents import Launch, LaunchedDescription, StartedProgram
from urdfkit.ros.launch.robot_arguments import launches_of_workspace

#: Most robots of several launch files that are expanded.
_MAX_ROBOTS = 8


def workspace_launches(context: Context) -> tuple[Launch, ...]:
    """The launch files of the workspace, in a large one not all of them."""
    return launches_of_workspace(context.source.path, context.resolver)


def all_launches(context: Context) -> tuple[Launch, ...]:
    """The launch file itself first, and those of the workspace."""
    return (context.launch, *workspace_launches(context))


def programs_of(launches: Iterable[Launch]) -> list[StartedProgram]:
    return [node for launch in launches for node in launch.programs]


def stock_key(program: StartedProgram, context: Context) -> str:
    """The name of a program in catalogues; empty if its source is in the workspace.

    Such a copy may have other topics, and another quality of service, than the released program.
    """
    packages = context.resolver.packages.known(context.source.path)
    return "" if program.package in packages else program.key


def distinct_descriptions(launches: Iterable[Launch]) -> list[LaunchedDescription]:
    """The robots of launch files, each once with the same arguments; none if they are many."""
    distinct = {
        (description.path, *sorted(description.arguments.items())): description
        for launch in launches
        for description in launch.descriptions
    }
    return list(distinct.values()) if len(distinct) <= _MAX_ROBOTS else []


def robots_of_workspace(context: Context) -> Iterator[Context]:
    """The robots that launch files of the workspace describe; none if they are many."""
    descriptions = distinct_descriptions(workspace_launches(context))
    yield from (robot for _, robot in context.expanded(descriptions))


def is_included(context: Context) -> bool:
    """True if another launch file includes this one, except for a test, which adds no robot."""
    return argument_checks.is_included(context.source.path, context.resolver, by_tests=False)

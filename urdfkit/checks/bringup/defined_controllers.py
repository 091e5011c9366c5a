"""Controllers that are defined for a launch file, or for all of its workspace."""

from collections.abc import Iterable, Sequence
from functools import lru_cache

from urdfkit.checks.bringup.workspace_launches import (
    distinct_descriptions,
    robots_of_workspace,
    workspace_launches,
)
from urdfkit.lint.rules import Context
from urdfkit.ros.controllers import Controller, read, with_parameters
from urdfkit.ros.launch.contents import Launch


def defined_controllers(context: Context) -> dict[str, Controller]:
    """The controllers in the parameter files of a launch file and of its robots, by name."""
    return _defined(context, (context.launch,), (robot for _, robot in context.described_robots))


def controllers_of(context: Context, launches: Sequence[Launch]) -> dict[str, Controller]:
    """The controllers of launch files, and of the robots that they describe, by name."""
    robots = (robot for _, robot in context.expanded(distinct_descriptions(launches)))
    return _defined(context, launches, robots)


@lru_cache(maxsize=1)  # several rules ask for those of the launch file that they check
def controllers_of_workspace(context: Context) -> dict[str, Controller]:
    """The controllers of all launch files of the workspace, by name."""
    launches, robots = workspace_launches(context), robots_of_workspace(context)
    return _defined(context, launches, robots) | defined_controllers(context)


def _defined(
    context: Context, launches: Iterable[Launch], robots: Iterable[Context]
) -> dict[str, Controller]:
    controllers: dict[str, Controller] = {}
    paths = dict.fromkeys(file.path for launch in launches for file in launch.parameters)
    sources = list(filter(None, map(context.resolver.readable, paths)))
    for source in sources:
        found = with_parameters(read(source), sources)
        controllers |= {controller.name: controller for controller in found}
    for robot in robots:
        found = with_parameters((controller for _, controller in robot.controllers), sources)
        controllers |= {controller.name: controller for controller in found}
    return controllers

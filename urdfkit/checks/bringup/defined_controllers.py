"""Controllers that are defined for a launch file, or for all of its workspace."""

from collections.abc import Iterator

from urdfkit.checks.bringup.workspace_launches import workspace_launches
from urdfkit.lint.rules import Context
from urdfkit.ros.controllers import Controller, read

#: Most robots of a workspace that are expanded.
_MAX_ROBOTS = 8


def defined_controllers(context: Context) -> dict[str, Controller]:
    """The controllers in the parameter files of a launch file and of its robots, by name."""
    controllers: dict[str, Controller] = {}
    paths = dict.fromkeys(file.path for file in context.launch.parameters)
    for source in filter(None, map(context.resolver.readable, paths)):
        controllers |= {controller.name: controller for controller in read(source)}
    for _, robot in context.described_robots:
        controllers |= {controller.name: controller for _, controller in robot.controllers}
    return controllers


def controllers_of_workspace(context: Context) -> dict[str, Controller]:
    """The controllers of all launch files of the workspace, by name."""
    controllers: dict[str, Controller] = {}
    launches = workspace_launches(context)
    paths = dict.fromkeys(file.path for launch in launches for file in launch.parameters)
    for source in filter(None, map(context.resolver.readable, paths)):
        controllers |= {controller.name: controller for controller in read(source)}
    for robot in robots_of_workspace(context):
        controllers |= {controller.name: controller for _, controller in robot.controllers}
    return controllers | defined_controllers(context)


def robots_of_workspace(context: Context) -> Iterator[Context]:
    """The robots that launch files of the workspace describe; none if they are many."""
    launches = workspace_launches(context)
    descriptions = {
        (description.path, *sorted(description.arguments.items())): description
        for launch in launches
        for description in launch.descriptions
    }
    for description in descriptions.values() if len(descriptions) <= _MAX_ROBOTS else ():
        robot = context.other_robot(description.path, description.arguments)
        if robot.reading.document is not None:
            yield robot

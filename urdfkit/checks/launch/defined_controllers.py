"""Controllers that are defined for a launch file."""

from urdfkit.lint.rules import Context
from urdfkit.ros.controllers import Controller, read


def defined_controllers(context: Context) -> dict[str, Controller]:
    """The controllers in the parameter files of a launch file and of its robots, by name."""
    controllers: dict[str, Controller] = {}
    for file in context.launch.parameters:
        if source := context.resolver.readable(file.path):
            controllers |= {controller.name: controller for controller in read(source)}
    for _, robot in context.described_robots:
        controllers |= {controller.name: controller for _, controller in robot.controllers}
    return controllers

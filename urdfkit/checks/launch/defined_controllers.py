"""The controllers that a launch file has at hand."""

from urdfkit.lint.rules import Context
from urdfkit.ros.controllers import Controller, read


def defined_controllers(context: Context) -> dict[str, Controller]:
    """The controllers in the parameter files of a launch file and of its robots, by name."""
    found: dict[str, Controller] = {}
    for file in context.launch.parameters:
        if source := context.resolver.readable(file.path):
            found |= {one.name: one for one in read(source)}
    for _, robot in context.described_robots:
        found |= {one.name: one for _, one in robot.controllers}
    return found

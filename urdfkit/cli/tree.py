"""``urdfkit tree``: the kinematic tree."""

from importlib import import_module
from typing import Any

from urdfkit.cli import output
from urdfkit.cli.decorators import described, in_formats
from urdfkit.cli.robot import one_robot, robot
from urdfkit.output.diagrams import FORMATS, text


@described("tree")
@one_robot
@in_formats(*FORMATS)
def command(inputs: dict[str, Any], format: str) -> int:
    """Draw the kinematic tree of a robot.

    Each link is drawn below its parent, with the joint between them: its type, axis, limits of
    position, effort and velocity, and mimic.

    Exit codes: 0 done, 2 the file cannot be read.

    Examples:
        urdfkit tree robot.urdf.xacro
        urdfkit tree robot.urdf.xacro --format svg > tree.svg
    """
    context = robot(inputs)
    if format == "text":
        output.write(text.render(context.tree, output.width()))
    else:
        output.write(import_module(f"urdfkit.output.diagrams.{format}").render(context.tree))
    return 0

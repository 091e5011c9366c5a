"""The robot_state_publisher is started without a robot description.

In ROS 2, the node reads the robot from its parameter `robot_description` and stops without it:
"parameter must not be empty". The same happens if the parameter is misspelt, contains the path of a
file instead of its text, or the text of an unexpanded xacro file (`open(path).read()`, the command
`cat`, or `textfile` in ROS 1). The node also accepts the path of a URDF as an argument, but does
not expand a xacro file there.

Sources:
    robot_state_publisher: https://github.com/ros/robot_state_publisher/blob/rolling/src/robot_state_publisher.cpp
"""

from collections.abc import Mapping

from urdfkit.core.suggest import TYPO, nearest
from urdfkit.lint.rules import (
    Context,
    Finding,
    Findings,
    Location,
    Need,
    Related,
    Severity,
    reported,
    rule,
)
from urdfkit.ros.launch.collect import needs_xacro
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import lacks_description

NAME = "robot.launch.py"
BAD = """\
from launch_ros.actions import Node

node = Node(
    package="robot_state_publisher",
    executable="robot_state_publisher",
    parameters=[{"robot_descripton": "<robot/>"}],
)
"""
GOOD = BAD.replace("descripton", "description")

_PARAMETER = "robot_description"
_EXPANDED = 'write ParameterValue(Command(["xacro ", path]), value_type=str)'


@rule(Severity.ERROR, needs=(Need.LAUNCH,), help="give the node the parameter robot_description")
def check(context: Context) -> Findings:
    yield from reported(context, "LAU015")
    for node in context.launch.started:
        parameters = node.parameters.every
        if node.package != "robot_state_publisher" or parameters is None:
            continue
        if node.words:
            yield from _unexpanded(node, parameters, context)
            continue
        if (parameters.get(_PARAMETER) or "").endswith((".urdf", ".xacro")):
            message = f"{_PARAMETER} is the path of a file, not the text of the robot"
            yield Finding(node.at, message, _EXPANDED)
        if lacks_description(node):
            names = sorted(parameters)
            mistake = next((name for name in names if nearest(name, [_PARAMETER], TYPO)), "")
            other = f"; '{mistake}' is not '{_PARAMETER}'" if mistake else ""
            message = f"robot_state_publisher has no parameter {_PARAMETER}{other}"
            yield _without_robot(context, node, message, has_typo=bool(mistake))


def _without_robot(
    context: Context, node: StartedProgram, message: str, *, has_typo: bool
) -> Finding:
    started = [other for other in context.launch.started if other.package == node.package]
    publishing = next((other for other in started if not lacks_description(other)), None)
    if has_typo or publishing is None or publishing.namespace != node.namespace:
        return Finding(node.at, message)
    note = Related(publishing.span, "this robot_state_publisher has the robot")
    help = "remove the node: another one publishes the robot"
    return Finding(node.at, message, help, related=(note,))


def _unexpanded(
    node: StartedProgram, parameters: Mapping[str, str | None], context: Context
) -> Findings:
    """A xacro file in the arguments of the node, which reads it as a URDF."""
    for word in node.words if _PARAMETER not in parameters else ():
        path = word.text or ""
        source = context.resolver.readable(path) if path.endswith(".xacro") else None
        if path.endswith(".xacro") and (source is None or needs_xacro(source)):
            file = (word.text or "").rpartition("/")[2]
            message = f"robot_state_publisher reads '{file}' as a URDF: nothing expands it"
            help = f"{_EXPANDED} as its parameter {_PARAMETER}"
            yield Finding(Location(word.span, node.frame), message, help)

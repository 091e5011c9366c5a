"""The robot description of a launch file does not expand, or is no text.

The launch stops, or `robot_state_publisher` starts without a robot. The errors themselves are
reported at their places in the xacro. If all that it lacks is a package that is not on this
machine, or a file that the build creates, that is reported there alone.

In Python, the output of a `Command` that is a parameter by itself is read as YAML. A `: ` in a
comment of the robot is enough for "Unable to parse the value of parameter robot_description as
yaml"; `ParameterValue(Command(...), value_type=str)` takes it as it is. The same holds in XML for a
`<param>` without `type="str"`. Where the robot has no such text yet, it is an info.

Sources:
    launch_ros, evaluate_parameters.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/utilities/evaluate_parameters.py
    xacro: https://wiki.ros.org/xacro
    robot_state_publisher: https://github.com/ros/robot_state_publisher/blob/rolling/src/robot_state_publisher.cpp
"""

from urdfkit.core.static_typing import Any
from urdfkit.lint.rule_index import get
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, rule
from urdfkit.ros.launch.contents import LaunchedDescription
from urdfkit.text.diagnostic import Problem
from urdfkit.xacro.errors import NOT_BUILT

NAME = "robot.launch"
_ROBOT = b'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="%s"/></robot>'
FILES = {"bad.xacro": _ROBOT % b"${x}", "good.xacro": _ROBOT % b"x"}
BAD = '<launch><param name="robot_description" command="xacro $(dirname)/bad.xacro"/></launch>'
GOOD = BAD.replace("bad.xacro", "good.xacro")


#: Characters of a line that a message quotes.
_LONGEST = 60
_NOT_YET = "which fails at the first ': ' in a comment"


@rule(
    Severity.ERROR,
    needs=(Need.LAUNCH,),
    help="fix the errors in the xacro, or pass the arguments that it needs",
)
def check(context: Context) -> Findings:
    for description in context.launch.descriptions:
        robot = context.other_robot(description.path, description.arguments)
        if robot.reading.document is None and not _may_expand(description, robot):
            first, *others = _errors(robot) or robot.reading.problems
            more = f", and {len(others)} more" if others else ""
            place = Location(description.frame.call.span, description.frame.outer)
            yield Finding(place, f"'{description.path}' does not expand: {first.message}{more}")
        elif description.is_yaml:
            place = Location(description.frame.call.span, description.frame.outer)
            reason = _why_no_text(robot)
            message = f"launch reads the robot description as YAML, {reason or _NOT_YET}"
            is_xml = description.frame.call.span.source.path.endswith(".xml")
            help = (
                'write type="str"'
                if is_xml
                else "write ParameterValue(Command(...), value_type=str)"
            )
            yield Finding(place, message, help, severity=None if reason else Severity.INFO)


def _may_expand(description: LaunchedDescription, robot: Context) -> bool:
    """True if it is given arguments whose values are not known here.

    Or if it lacks packages only that this machine does not have, or files that the build creates:
    that is reported where they are needed, as are the errors that it has with its defaults. Macros
    that call each other for ever may get others of their names from these packages.
    """
    problems = _errors(robot) or robot.reading.problems
    codes = {problem.code for problem in problems if not problem.message.startswith(NOT_BUILT)}
    return codes in (set(), {"XAC011"}, {"XAC011", "XAC013"}) or not description.is_whole


def _errors(robot: Context) -> list[Problem]:
    """The errors of an expansion, a package that is not on this machine last."""
    found = [one for one in robot.reading.problems if get(one.code).severity is Severity.ERROR]
    return sorted(found, key=lambda problem: problem.code == "XAC011")


def _why_no_text(robot: Context) -> str:
    """Why YAML finds no text in an expanded robot; empty if it does, or the robot is broken."""
    if robot.reading.document is None or robot.reading.problems:
        return ""
    import yaml  # 15 ms, and most descriptions have a type

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        for event in yaml.parse(robot.text, loader):
            if isinstance(event, (yaml.MappingStartEvent, yaml.SequenceStartEvent)):
                mark: Any = event.start_mark
                return f"which finds no text in line {mark.line + 1} of it"
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        lines = robot.text.decode("utf-8", "replace").split("\n")[mark.line :]
        shown = lines[0].strip()[:_LONGEST] if lines else ""
        return f"which fails in line {mark.line + 1} of it, '{shown}': {error.problem}"
    except yaml.YAMLError as error:
        return f"which fails: {error}"
    return ""

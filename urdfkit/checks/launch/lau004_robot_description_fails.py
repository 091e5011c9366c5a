"""The robot description of a launch file does not expand, or is not read as text.

The launch stops, or `robot_state_publisher` starts without a robot. So it does if the file only
defines macros that another one calls: "No link elements found in urdf file". Only arguments that
the launch file does not pass are reported here, also those that the xacro uses above their default;
other errors are reported in the xacro file, which is checked with the arguments of the launch file.

In Python, a `Command` that is passed as a parameter directly is read as YAML. A tab, or a `: ` in a
comment, of the robot is enough for "Unable to parse the value of parameter robot_description as
yaml"; `ParameterValue(Command(...), value_type=str)` is read as text. In XML, a `<param>` needs
`type="str"`. An info if the current robot description is valid YAML text.

Sources:
    launch_ros, evaluate_parameters.py: https://github.com/ros2/launch_ros/blob/rolling/launch_ros/launch_ros/utilities/evaluate_parameters.py
    xacro: https://wiki.ros.org/xacro
    robot_state_publisher: https://github.com/ros/robot_state_publisher/blob/rolling/src/robot_state_publisher.cpp
"""

import os

from urdfkit.core.static_typing import Any
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.workspace.includes import includer

NAME = "robot.launch"
FILES = {
    "r.xacro": b'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    b'<link name="$(arg side)_arm"/></robot>'
}
BAD = '<launch><param name="robot_description" command="xacro $(dirname)/r.xacro"/></launch>'
GOOD = BAD.replace("r.xacro", "r.xacro side:=left")


#: Characters of a line that a message quotes.
_MAX_CHARACTERS = 60
_NOT_YET = "which fails at the first ': ' in a comment"


@rule(Severity.ERROR, needs=(Need.LAUNCH,), help="pass the argument: NAME:=VALUE")
def check(context: Context) -> Findings:
    for description in context.launch.descriptions:
        robot = context.other_robot(description.path, description.arguments)
        is_read = robot.reading.document is not None
        codes = ("XAC020",) if is_read else ("XAC010", "XAC020")
        missing = [problem for problem in robot.reading.problems if problem.code in codes]
        if missing and description.is_whole:
            place = Location(description.frame.call.span, description.frame.outer)
            message = f"'{description.path}' does not expand: {missing[0].message}"
            note = Related(missing[0].span, "here")
            yield Finding(place, message, missing[0].help, related=(note,))
        elif is_read and description.is_whole and _is_empty(robot):
            place = Location(description.frame.call.span, description.frame.outer)
            message = f"'{description.path}' has no link: robot_state_publisher stops"
            yield Finding(place, message, _how_to_fill(robot))
        elif is_read and description.is_yaml:
            place = Location(description.frame.call.span, description.frame.outer)
            reason = _yaml_error(robot, description.is_expanded)
            message = f"launch reads the robot description as YAML, {reason or _NOT_YET}"
            is_xml = description.frame.call.span.source.path.endswith(".xml")
            help = (
                'write type="str"'
                if is_xml
                else "write ParameterValue(Command(...), value_type=str)"
            )
            yield Finding(place, message, help, severity=None if reason else Severity.INFO)


def _is_empty(robot: Context) -> bool:
    """True for a file that only defines macros."""
    xacro = robot.reading.xacro
    return xacro is not None and xacro.is_library and not robot.document.root.children


def _how_to_fill(robot: Context) -> str:
    """The file that includes one of macros alone, which may call them; else the missing call."""
    path, xacro = robot.source.path, robot.reading.xacro
    if file := includer(path, robot.resolver.packages):
        return f"name {os.path.basename(file)}, which includes it"
    own = [one for one in xacro.macros if one.tag.source.path == path] if xacro else []
    return f"call its macro: <xacro:{own[0].name} .../>" if len(own) == 1 else "call its macros"


def _yaml_error(robot: Context, is_expanded: bool) -> str:
    """Why a robot is not a YAML string; empty if it is, or if the robot has problems.

    Args:
        is_expanded: True if launch reads the output of xacro, also of a plain URDF, which xacro
            indents with spaces.
    """
    if robot.reading.document is None or robot.reading.problems:
        return ""
    import yaml  # 15 ms, and most descriptions have a type

    from urdfkit.text.located_yaml import loader_as_in_python

    text = robot.text
    if is_expanded and robot.reading.xacro is None:
        from urdfkit.xacro import expand

        expanded = expand(robot.source, robot.resolver)
        text = expanded.text().encode() if expanded.document is not None else text
    try:
        for event in yaml.parse(text, loader_as_in_python(text)):
            if isinstance(event, (yaml.MappingStartEvent, yaml.SequenceStartEvent)):
                mark: Any = event.start_mark
                return f"which finds a mapping or list, not text, in line {mark.line + 1}"
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark
        lines = text.decode("utf-8", "replace").split("\n")[mark.line :]
        shown = lines[0].strip()[:_MAX_CHARACTERS] if lines else ""
        return f"which fails in line {mark.line + 1}, '{shown}': {error.problem}"
    except yaml.YAMLError as error:
        return f"which fails: {error}"
    return ""

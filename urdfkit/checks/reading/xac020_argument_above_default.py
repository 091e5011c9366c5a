"""An argument is used above the `<xacro:arg>` that gives it a default.

xacro reads from top to bottom: at the use, the default is not defined yet, and xacro stops with
"Undefined substitution argument", unless the value is passed. The usual place is the name of the
robot in the root element. urdfkit uses the default anyway, to check the rest of the model. If each
launch file that starts the robot passes values that are known only at run time, it is not reported;
nor if a launch file names the robot and the argument for a function that calls xacro, or the
configuration of MoveIt Pro does.

Sources:
    xacro: https://wiki.ros.org/xacro
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
    measured: 12 public entry points stop at it
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule
from urdfkit.robot.samples import xacro_xml

GOOD = xacro_xml('<xacro:arg name="name" default="arm"/>', '<link name="base"/>')
BAD = GOOD.replace('name="r"', 'name="$(arg name)"')


@rule(
    Severity.ERROR,
    needs=(),
    help="move the <xacro:arg> above the first use; for the robot's own name write the name",
)
def check(context: Context) -> Findings:
    for problem, finding in zip(
        context.problems("XAC020"), reported(context, "XAC020"), strict=True
    ):
        if not _may_be_passed(context, problem.argument):
            yield finding


def _may_be_passed(context: Context, argument: str) -> bool:
    from urdfkit.ros.launch.robot_arguments import (  # for few robots
        is_handed_on,
        is_in_moveit_pro,
        known_at_run_time,
    )

    path, resolver = context.source.path, context.resolver
    is_unknown = bool(known_at_run_time(path, (argument,), resolver))
    return (
        is_unknown
        or is_handed_on(path, argument, resolver)
        or is_in_moveit_pro(path, argument, resolver)
    )

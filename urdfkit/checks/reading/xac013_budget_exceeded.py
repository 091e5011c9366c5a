"""The expansion exceeds a limit of depth, size or time.

Macros that call themselves, circular includes, a number with a million digits: limits of depth,
number of elements, size of values and time stop them, so that a hostile or broken file cannot block
the machine that checks it. They are a hundred times what the largest public robot needs.

Sources:
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
    measured: the largest public robot has 1 201 links
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule
from urdfkit.robot.samples import xacro_xml

_CALL = '<xacro:again n="${n + 1}"/>'
BAD = xacro_xml(
    f'<xacro:macro name="again" params="n">{_CALL}</xacro:macro>', '<xacro:again n="0"/>'
)
GOOD = BAD.replace(_CALL, f'<xacro:if value="${{n &lt; 3}}">{_CALL}</xacro:if>')


@rule(
    Severity.ERROR,
    needs=(),
    help="look for a macro, an include or a property that refers to itself",
)
def check(context: Context) -> Findings:
    if not context.problems("XAC011"):  # whose macros have the names of those that call them
        yield from reported(context, "XAC013")

"""A property is defined twice in the same block before its first value is used.

The first definition has no effect, so one of the two is left over, or has the wrong name. A
conditional default (`<xacro:if>`) and a property that is used in between are not reported; nor is a
property if an include is not found, as it may use the first value.

Sources:
    xacro: https://wiki.ros.org/xacro
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule
from urdfkit.robot.samples import xacro_xml

BAD = xacro_xml(
    '<xacro:property name="width" value="0.3"/>',
    '<xacro:property name="width" value="0.4"/>',
    '<link name="base_${width}"/>',
)
GOOD = BAD.replace('name="width" value="0.4"', 'name="height" value="0.4"')


@rule(
    Severity.WARNING,
    needs=(),
    help="delete one of the two, or use default= where a value may already be given",
)
def check(context: Context) -> Findings:
    return reported(context, "XAC008")

"""The sandbox rejects an expression or a file access.

xacro evaluates Python, and its own filter can be bypassed: expanding a model runs code of its
author. Here expressions pass an allow-list (numbers, text, lists, comparisons, calls of xacro's
functions), `$(env)` reads only variables of ROS and Gazebo, and a model includes or loads only
files in its workspace and its packages: a path outside of them works on no other machine, either.
None of 14 081 expressions in public models is rejected.

Sources:
    xacro: https://wiki.ros.org/xacro
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule
from urdfkit.robot.samples import xacro_xml

BAD = xacro_xml('<link name="${().__class__.__name__}"/>')
GOOD = xacro_xml('<link name="${str(1 + 1)}"/>')


@rule(
    Severity.ERROR,
    needs=(),
    help="write it with plain arithmetic, or add --trust if you trust the author of the model",
)
def check(context: Context) -> Findings:
    return reported(context, "XAC009")

"""Expanding the file gives a warning.

An unknown attribute of a xacro tag, an include whose pattern matches no file, a warning that the
model prints with `xacro.warning()`, or a property or parameter with the name of something that
expressions already have ("redefining global symbol"): `pi`, `e`, `radians`, `sin`, `min`, `len`
and the other names of Python's math module. Such a property hides the constant or function in every
file that is included afterwards; with `e` or `pi` that gives wrong numbers elsewhere. Also a
variable of `$(optenv)` that is set and that urdfkit does not read: ROS may start another robot.

`load_yaml`, `sorted` and other functions moved into the namespaces `xacro` and `python`; the bare
names print a warning today and will be removed. An info.

Sources:
    xacro: https://wiki.ros.org/xacro
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule
from urdfkit.robot.samples import xacro_xml

BAD = xacro_xml('<link name="l${sorted([3, 1])[0]}"/>')
FIXED = GOOD = BAD.replace("sorted", "python.sorted")


@rule(Severity.WARNING, needs=(), help="correct or remove it; xacro ignores what it does not know")
def check(context: Context) -> Findings:
    return reported(context, "XAC017")

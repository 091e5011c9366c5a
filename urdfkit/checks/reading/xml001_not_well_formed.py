"""The file is not well-formed XML.

Most parsers reject the whole file, among them xacro and Python's XML parsers. urdfdom accepts a
stray `&`, a missing space, or content after the root element, which it ignores without a message.
All errors are listed where they have to be fixed, not where a parser stops: a tag that is not
closed, a missing quote, a stray `<` or `&`, an attribute given twice, a NUL byte, `--` inside a
comment, a comment that begins with `<--`, an element or text after `</robot>`.

A template is an info: a generator replaces the placeholder that is the name of a tag, as in
`<xacro:$ROBOT_NAME$>` or `<xacro:{{ name }}>`.

Sources:
    XML 1.0: https://www.w3.org/TR/REC-xml/
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

import re

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule

BAD = """\
<robot name="r">
  <!-- ros2 launch r show.launch.py --debug -->
  <link name="a"/>
</robot>"""
FIXED = GOOD = BAD.replace("--debug", "- -debug")


#: A tag whose name begins with the placeholder of a template.
_PLACEHOLDER_TAG = re.compile(rb"<(?:[A-Za-z]\w*:)?(?:\$\w+\$|\{\{|@\w+@)")


@rule(Severity.ERROR, needs=())
def check(context: Context) -> Findings:
    for finding in reported(context, "XML001"):
        is_template = _PLACEHOLDER_TAG.search(context.source.data)
        yield finding._replace(severity=Severity.INFO) if is_template else finding

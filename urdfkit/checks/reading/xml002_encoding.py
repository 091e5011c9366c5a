"""The file is not in UTF-8, or not in the encoding that it declares.

xacro stops with a UnicodeDecodeError, and strict XML parsers reject the file. The usual cause is an
editor on Windows that saves a comment as GBK, Latin-1 or CP-1252 while the file declares UTF-8,
which is also the default of XML; PowerShell's `>` writes UTF-16, which neither xacro nor urdfdom
reads. Save the file as UTF-8.

Sources:
    XML 1.0: https://www.w3.org/TR/REC-xml/
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from urdfkit.lint.rules import Context, Findings, Severity, reported, rule

BAD = b'<robot name="r"><!-- gr\xf6\xdfe --><link name="a"/></robot>'
GOOD = BAD.decode("latin-1").encode()


@rule(
    Severity.ERROR,
    needs=(),
    help="save the file as UTF-8, or declare its real encoding in the first line",
)
def check(context: Context) -> Findings:
    return reported(context, "XML002")

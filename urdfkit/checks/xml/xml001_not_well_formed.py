"""The file is not well-formed XML.

Most readers refuse the whole file, xacro and Python's XML readers among them; urdfdom forgives a
stray `&` or a missing blank, and then may read something else than was meant. All errors are
listed, each where it has to be mended and not where a parser gave up: a tag that is not closed, a
missing quote, a stray `<` or `&`, an attribute given twice, a NUL byte, `--` inside a comment.

Sources:
    XML 1.0: https://www.w3.org/TR/REC-xml/
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="r">
  <!-- ros2 launch r show.launch.py --debug -->
  <link name="a"/>
</robot>"""
FIXED = GOOD = BAD.replace("--debug", "- -debug")


@rule(
    "XML001",
    "not-well-formed",
    Severity.ERROR,
    needs=(),
    help="close every tag and quote; write < as &lt; and & as &amp;",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XML001")

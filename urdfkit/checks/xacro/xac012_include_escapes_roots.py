"""A file outside the workspace and the packages is included or loaded.

A model from somebody else could read any file of this machine that way, and a model that reaches
outside its package does not work anywhere else either.

Sources:
    xacro: https://wiki.ros.org/xacro
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="/etc/hostname"/>
</robot>
"""
GOOD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
</robot>
"""


@rule(
    "XAC012",
    "include-escapes-roots",
    Severity.ERROR,
    needs=(),
    help="move the file into a package, or add --trust if you trust the model's author",
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XAC012")

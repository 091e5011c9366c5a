"""A property is defined and never used.

Nothing breaks, but a reader changes the number and wonders why the robot stays as it is. Mostly a
use was deleted, or the name is misspelt where it was to be used. Properties of macro libraries and
of files with includes that this expansion leaves out are not judged.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, Need, Written, rule

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="width" value="0.3"/>
  <link name="base"/>
</robot>
"""
GOOD = BAD.replace('"base"', '"base_${width}"')


@rule(
    "XAC004",
    "unused-property",
    Severity.WARNING,
    needs=(Need.XACRO,),
    help="delete it, or use it where it was meant",
)
def check(subject: Subject) -> Iterator[Finding]:
    xacro = subject.xacro
    if xacro.is_library or not xacro.is_complete:
        return
    for definition in xacro.properties:
        name = definition.name.removeprefix("**")
        if definition.tag.source is subject.source and name not in xacro.usage.names:
            yield Finding(
                Written(definition.tag.span, definition.frame), f"property '{name}' is never used"
            )

"""A property is defined and never used.

Nothing breaks, but a reader changes the number and wonders why the robot stays as it is. Mostly a
use was deleted, or misspells the name. Files that others include, libraries of macros, and files
with includes that this expansion leaves out are not judged: the property may be used elsewhere.

Sources:
    xacro: https://wiki.ros.org/xacro
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import remove_spans
from urdfkit.workspace.includes import is_included

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="width" value="0.3"/>
  <xacro:property name="side" value="left"/>
  <link name="${side}_base"/>
</robot>
"""
GOOD = BAD.replace("${side}_base", "${side}_${width}")
FIXED = BAD.replace('  <xacro:property name="width" value="0.3"/>\n', "")


@rule(
    "XAC004",
    "unused-property",
    Severity.WARNING,
    needs=(Need.XACRO, Need.FILES),
    help="delete it, or use it where it was meant",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    xacro = subject.xacro
    if xacro.is_library or not xacro.is_complete:
        return
    unused = [
        definition
        for definition in xacro.properties
        if definition.tag.source is subject.source
        and definition.name.removeprefix("**") not in xacro.usage.names
    ]
    if unused and not is_included(subject.source.path, subject.resolver.packages):
        for definition in unused:
            place = Location(definition.tag.span, definition.frame)
            name = definition.name.removeprefix("**")
            edits = remove_spans([definition.tag.whole_span])
            yield Finding(
                place,
                f"property '{name}' is never used",
                fix=Fix("delete the property", edits),
                alike="unused",
            )

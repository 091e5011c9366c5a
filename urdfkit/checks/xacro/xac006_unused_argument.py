"""An argument is declared and never used.

Whoever passes `name:=value` believes that it does something. Delete the declaration, or use
`$(arg name)` where it was meant. Files that others include, and files with includes that this
expansion leaves out, are not judged.

Sources:
    xacro: https://wiki.ros.org/xacro
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.workspace.includes import is_included

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="prefix" default=""/>
  <link name="base"/>
</robot>
"""
GOOD = BAD.replace('"base"', '"$(arg prefix)base"')


@rule(
    "XAC006",
    "unused-argument",
    Severity.WARNING,
    needs=(Need.XACRO, Need.FILES),
    help="delete the <xacro:arg>, or use $(arg ...) where it was meant",
)
def check(subject: Subject) -> Iterator[Finding]:
    xacro = subject.xacro
    if xacro.is_library or not xacro.is_complete:
        return
    unused = [
        argument
        for argument in xacro.arguments
        if argument.tag.source is subject.source and argument.name not in xacro.usage.names
    ]
    if unused and not is_included(subject.source.path, subject.resolver.packages):
        for argument in unused:
            place = Location(argument.tag.span, argument.frame)
            yield Finding(place, f"argument '{argument.name}' is never used", alike="unused")

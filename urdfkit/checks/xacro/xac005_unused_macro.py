"""A macro is defined and never called.

It may be left over. A macro of a library that other files include is no finding: the package is
searched for files that include this one.

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
  <xacro:macro name="arm" params="side">
    <link name="${side}_arm"/>
    <joint name="${side}" type="fixed"><parent link="base"/><child link="${side}_arm"/></joint>
  </xacro:macro>
  <link name="base"/>
</robot>
"""
GOOD = BAD.replace("</robot>", '  <xacro:arm side="left"/>\n</robot>')


@rule(
    "XAC005",
    "unused-macro",
    Severity.INFO,
    needs=(Need.XACRO, Need.MODEL, Need.FILES),
    help="delete it, or call it with <xacro:...>",
)
def check(subject: Subject) -> Iterator[Finding]:
    xacro = subject.xacro
    if xacro.is_library or not xacro.is_complete or "call" in xacro.usage.calls:
        return
    unused = [
        macro
        for macro in xacro.macros
        if macro.tag.source is subject.source and macro.name not in xacro.usage.calls
    ]
    if unused:  # one that is called without its prefix is XAC002's finding
        tags = {element.tag for element in subject.document.root.walk()}
        unused = [macro for macro in unused if macro.name not in tags]
    if unused and not is_included(subject.source.path, subject.resolver.packages):
        for macro in unused:
            place = Location(macro.tag.span, macro.frame)
            yield Finding(place, f"macro '{macro.name}' is never called")

"""The SRDF beside the robot is not well-formed.

move_group stops with it, and the rules about groups, states and allowed collisions cannot look.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, Need, rule
from urdfkit.ros.moveit.srdf import unreadable
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="bad">
  <link name="base"/>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"><link name="base"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><link name="base"/></group>
</robot>
""",
}


@rule("SRD018", "unreadable", Severity.ERROR, needs=(Need.MODEL, Need.SRDF), help="mend the tags")
def check(subject: Subject) -> Iterator[Finding]:
    if subject.is_part:
        return
    name = subject.model.name
    for problem in unreadable(subject.source.path, name, subject.resolver):
        at = Location(problem.span, problem.frame)
        yield Finding(at, problem.message, problem.help, related=problem.related)

"""A planning group holds nothing.

MoveIt prints "Group is empty" and leaves it out, so that whatever refers to it fails. Name the
links, the joints or the chain that belong to it, or delete it.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="bad">
  <link name="arm"/>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><link name="arm"/></group>
</robot>
""",
}


@rule(
    "SRD003",
    "group-empty",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="put links, joints or a chain into it, or delete it",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for name, elements in srdf.groups_by_name.items():
        if not any(element.children for element in elements):
            yield Finding(elements[0], f"group '{name}' holds nothing")

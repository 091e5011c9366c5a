"""A planning group holds nothing.

MoveIt prints "Group is empty" and leaves it out, so that whatever refers to it fails. Name the
links, the joints or the chain that belong to it, or delete it.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="arm"/>
  <link name="hand"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
  <joint name="wrist" type="fixed">
    <parent link="arm"/>
    <child link="hand"/>
  </joint>
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

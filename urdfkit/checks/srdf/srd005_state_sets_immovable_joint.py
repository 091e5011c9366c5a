"""A named state sets a joint that cannot be set.

A fixed joint has no position: MoveIt ignores the value or refuses the state. Leave the joint out. A
joint that mimics another may be set, to the value that it has anyway; maintained robots do so.

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
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
  <link name="hand"/>
  <link name="finger"/>
  <joint name="wrist" type="fixed">
    <parent link="arm"/>
    <child link="hand"/>
  </joint>
  <joint name="knuckle" type="continuous">
    <parent link="hand"/>
    <child link="finger"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"><joint name="knuckle"/></group>
  <group_state name="up" group="arm"><joint name="wrist" value="0"/></group_state>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><joint name="knuckle"/></group>
  <group_state name="up" group="arm"><joint name="knuckle" value="0"/></group_state>
</robot>
""",
}


@rule(
    "SRD005",
    "state-sets-immovable-joint",
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="leave the joint out of the state",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for state in srdf.states:
        for element in state.all("joint"):
            joint = subject.model.joints_by_name.get(element.get("name") or "")
            if joint is not None and joint.kind == "fixed":
                message = f"state '{state.get('name')}' sets joint '{joint.name}', which is fixed"
                yield Finding(element, message)

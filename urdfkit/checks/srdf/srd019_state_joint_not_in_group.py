"""A state of a group sets a joint that the group does not have.

MoveIt warns and leaves the value out, so the robot goes elsewhere than the state says.

Sources:
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

_ROBOT = """\
<robot name="{name}">
  <link name="base"/>
  <link name="arm"/>
  <link name="hand"/>
  <joint name="shoulder" type="continuous">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit effort="10" velocity="1"/>
  </joint>
  <joint name="wrist" type="continuous">
    <parent link="arm"/>
    <child link="hand"/>
    <axis xyz="0 0 1"/>
    <limit effort="10" velocity="1"/>
  </joint>
</robot>
"""
BAD = _ROBOT.format(name="bad")
GOOD = _ROBOT.format(name="good")
_SRDF = b"""\
<robot name="bad">
  <group name="arm"><chain base_link="base" tip_link="arm"/></group>
  <group_state name="up" group="arm"><joint name="wrist" value="1"/></group_state>
</robot>
"""
FILES = {
    "bad.srdf": _SRDF,
    "good.srdf": _SRDF.replace(b"wrist", b"shoulder").replace(b"bad", b"good"),
}


@rule(
    "SRD019",
    "state-joint-not-in-group",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="take the joint out of the state, or into the group",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for state in srdf.states:
        group = state.get("group") or ""
        links = srdf.links_of(group)
        if not links:
            continue
        for element in state.all("joint"):
            joint = subject.model.joints_by_name.get(element.get("name") or "")
            if joint is None or joint.child is None or joint.child.value in links:
                continue
            yield Finding(
                element,
                f"state '{state.get('name')}': joint '{joint.name}' is not in group '{group}'",
                related=(Related(srdf.groups_by_name[group][0].span, "the group"),),
            )

"""An end effector and the group that carries it do not fit together.

The links of the end effector's group must not be in the parent group, and the parent link must be
in it. MoveIt loads the robot all the same, but takes the hand for a part of the arm, attaches it
to another group that has the parent link, or to none.

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.text.diagnostic import Severity

BAD = """\
<robot name="bad">
  <link name="arm"/>
  <link name="hand"/>
  <joint name="flange" type="fixed">
    <parent link="arm"/>
    <child link="hand"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"><link name="arm"/><link name="hand"/></group>
  <group name="hand"><link name="hand"/></group>
  <end_effector name="hand" group="hand" parent_link="arm" parent_group="arm"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><link name="arm"/></group>
  <group name="hand"><link name="hand"/></group>
  <end_effector name="hand" group="hand" parent_link="arm" parent_group="arm"/>
</robot>
""",
}


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="let the groups share no link, and let the parent link be one of the parent group",
)
def check(subject: Subject) -> Findings:
    srdf = subject.srdf
    if srdf is None:
        return
    for effector in srdf.end_effectors:
        name, parent = effector.get("name"), effector.get("parent_group")
        hand = srdf.links_of(effector.get("group") or "")
        arm = srdf.links_of(parent) if parent else set()
        if shared := sorted(hand & arm):
            links = ", ".join(f"'{link}'" for link in shared)
            yield Finding(effector, f"end effector '{name}' and group '{parent}' share {links}")
        link = effector.get("parent_link")
        if link in hand:
            yield Finding(effector, f"end effector '{name}' is attached to '{link}', its own link")

"""The tip link of a chain is not a descendant of its base link.

A chain goes from a base link down the tree to a tip link. MoveIt rejects any other chain, and the
group has no joints. Base and tip are swapped, or one of them is on another branch.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.text.diagnostic import Severity

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="hand"/>
  <joint name="slide" type="prismatic">
    <parent link="base"/>
    <child link="hand"/>
    <axis xyz="1 0 0"/>
    <limit lower="0" upper="0.4" effort="50" velocity="0.2"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"><chain base_link="hand" tip_link="base"/></group>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><chain base_link="base" tip_link="hand"/></group>
</robot>
""",
}


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="swap base and tip, or name links of one branch",
)
def check(subject: Subject) -> Findings:
    srdf = subject.srdf
    if srdf is None:
        return
    links = srdf.known("link")
    for group in srdf.groups:
        for chain in group.all("chain"):
            base, tip = chain.get("base_link") or "", chain.get("tip_link") or ""
            if base in links and tip in links and srdf.way(base, tip) is None:
                message = (
                    f"group '{group.get('name')}': link '{tip}' is not a descendant of '{base}'"
                )
                yield Finding(chain, message)

"""An element of the SRDF lacks an attribute that it needs, or has text for a number.

srdfdom writes a line to the log and leaves the element out: the group has no chain, the state does
not set the joint, the pair of links is checked for collisions.

Sources:
    srdfdom, model.cpp: https://github.com/moveit/srdfdom/blob/ros2/src/model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.robot.model import number
from urdfkit.ros.moveit.srdf_grammar import lacking
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="arm"/>
  <joint name="shoulder" type="fixed">
    <parent link="base"/>
    <child link="arm"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"><chain base_link="base"/></group>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><chain base_link="base" tip_link="arm"/></group>
</robot>
""",
}


@rule("SRD017", "incomplete-element", Severity.ERROR, needs=(Need.MODEL, Need.SRDF))
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for element, name in lacking(srdf.root):
        message = f"<{element.tag}> has no {name}, so MoveIt leaves it out"
        yield Finding(element, message, f"add {name}")
    for state in srdf.states:
        for joint in state.all("joint"):
            value = joint.attributes.get("value")
            if value is None or not value.value.strip():
                continue
            if any(number(part) is None for part in value.value.split()):
                who = f"state '{state.get('name')}'"
                message = f"{who}: '{value.value}' is not a position of a joint"
                yield Finding(value, message, "write a number, in rad or m")

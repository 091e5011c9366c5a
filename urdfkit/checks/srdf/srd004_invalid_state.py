"""A named state sets a joint outside its limits, or a fixed joint.

MoveIt does not plan to a state outside the limits: "goal state is out of bounds". The limits were
changed after the state was written, or the value is in degrees. A fixed joint has no position:
MoveIt ignores the value or rejects the state. A mimic joint may be set, to the value that it has
anyway; maintained robots do so.

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, URDF and SRDF: https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.robot.joints import unit
from urdfkit.robot.model import number
from urdfkit.text.diagnostic import Severity

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="arm"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <group name="arm"><joint name="shoulder"/></group>
  <group_state name="up" group="arm"><joint name="shoulder" value="1.57"/></group_state>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><joint name="shoulder"/></group>
  <group_state name="up" group="arm"><joint name="shoulder" value="0.9"/></group_state>
</robot>
""",
}

#: MoveIt's own tolerance is larger; rounded values such as 1.57 for pi/2 pass.
_ROUNDING = 1e-3


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF))
def check(subject: Subject) -> Findings:
    for state in subject.srdf.states if subject.srdf else ():
        for element in state.all("joint"):
            joint = subject.model.joints_by_name.get(element.get("name") or "")
            value = number(element.get("value"))
            if joint is None:
                continue
            who = f"state '{state.get('name')}': joint '{joint.name}'"
            if joint.kind == "fixed":
                yield Finding(element, f"{who} is fixed", "remove the joint from the state")
            if joint.kind not in ("revolute", "prismatic") or joint.limit is None:
                continue
            lower, upper = joint.limit.lower, joint.limit.upper
            if lower is None or upper is None or value is None:
                continue
            if not lower.value - _ROUNDING <= value <= upper.value + _ROUNDING:
                yield Finding(
                    element,
                    f"{who}: {value:g} {unit(joint)} is outside its limits "
                    f"[{lower.value:g}, {upper.value:g}] {unit(joint)}",
                    "write a value within the limits",
                )

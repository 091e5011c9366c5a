"""A named state puts a joint outside its limits.

MoveIt refuses to plan to it: "goal state is out of bounds". The limits changed after the state was
written, or the value is in degrees.

Sources:
    MoveIt, URDF and SRDF: https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.robot.joints import unit
from urdfkit.robot.model import number
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

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


@rule(
    "SRD004",
    "state-outside-limits",
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="give a value within the limits",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for state in srdf.states:
        for element in state.all("joint"):
            joint = subject.model.joints_by_name.get(element.get("name") or "")
            value = number(element.get("value"))
            if joint is None or joint.limit is None or value is None:
                continue
            lower, upper = joint.limit.lower, joint.limit.upper
            if joint.kind not in ("revolute", "prismatic") or lower is None or upper is None:
                continue
            if not lower.value - _ROUNDING <= value <= upper.value + _ROUNDING:
                bounds = f"{lower.value:g} to {upper.value:g} {unit(joint)}"
                message = f"state '{state.get('name')}': joint '{joint.name}' at {value:g}"
                yield Finding(element, f"{message} is outside its limits {bounds}")

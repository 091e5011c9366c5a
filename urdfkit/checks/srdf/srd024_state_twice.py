"""Two states of one group have the same name.

MoveIt keeps the last one, and ignores the other without a message.

Sources:
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.text.diagnostic import Related, Severity
from urdfkit.text.document import Element

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="arm"/>
  <joint name="shoulder" type="continuous">
    <parent link="base"/>
    <child link="arm"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
_SRDF = b"""\
<robot name="bad">
  <group name="arm"><chain base_link="base" tip_link="arm"/></group>
</robot>
"""
_STATE = b"""\
  <group_state name="home" group="arm"><joint name="shoulder" value="0"/></group_state>
  <group_state name="up" group="arm"><joint name="shoulder" value="1"/></group_state>
</robot>
"""
FILES = {
    "bad.srdf": _SRDF.replace(b"</robot>\n", _STATE.replace(b'"up"', b'"home"')),
    "good.srdf": _SRDF.replace(b"</robot>\n", _STATE).replace(b"bad", b"good"),
}


@rule(Severity.WARNING, needs=(Need.MODEL, Need.SRDF), help="give one of them another name")
def check(subject: Subject) -> Findings:
    first: dict[tuple[str | None, str | None], Element] = {}
    for state in subject.srdf.states if subject.srdf else ():
        name, group = state.get("name"), state.get("group")
        before = first.setdefault((name, group), state)
        if before is not state and name:
            note = Related(before.span, "first defined here")
            message = f"duplicate state '{name}' of group '{group}'; MoveIt keeps the last"
            yield Finding(state, message, related=(note,))

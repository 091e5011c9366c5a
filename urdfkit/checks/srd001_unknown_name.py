"""The SRDF names a link, joint or group that does not exist.

MoveIt drops the group or the state that refers to it, and planning then fails with "group not
found" or with joints that never move. The SRDF lags behind the robot, or the name is misspelt.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.nearest import did_you_mean
from urdfkit.rules import Finding, Need, rule

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
  <group name="arm"><link name="forearm"/></group>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <group name="arm"><link name="arm"/></group>
</robot>
""",
}


@rule(
    "SRD001",
    "unknown-name",
    Severity.ERROR,
    needs=(Need.MODEL, Need.SRDF),
    help="mend the name, or make the SRDF anew for this robot",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    for kind, attribute in srdf.references():
        known = srdf.known(kind)
        if attribute.value and attribute.value not in known:
            hint = did_you_mean(attribute.value, known)
            yield Finding(attribute, f"there is no {kind} '{attribute.value}'{hint}")

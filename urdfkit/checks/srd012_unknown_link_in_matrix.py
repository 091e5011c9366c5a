"""The collision matrix names a link that the robot does not have.

MoveIt prints "Link is not known to URDF. Cannot disable collisions" and goes on; the line does
nothing, and the pair that it was meant for may be checked in vain. The matrix lags behind the
robot.
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
  <disable_collisions link1="base" link2="forearm" reason="Never"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <disable_collisions link1="base" link2="arm" reason="Never"/>
</robot>
""",
}


@rule(
    "SRD012",
    "unknown-link-in-matrix",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="compute the collision matrix anew, or mend the name",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    links = srdf.known("link")
    for pair in (*srdf.root.all("disable_collisions"), *srdf.root.all("enable_collisions")):
        for key in ("link1", "link2"):
            attribute = pair.attributes.get(key)
            if attribute is not None and attribute.value not in links:
                hint = did_you_mean(attribute.value, links)
                yield Finding(attribute, f"there is no link '{attribute.value}'{hint}")

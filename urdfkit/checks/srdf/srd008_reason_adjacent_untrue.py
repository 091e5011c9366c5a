"""A pair of links is allowed to collide as "Adjacent" although no joint holds them together.

The pair is then never checked, whatever the robot does. The matrix is of an older robot, or the
reason was written by hand. Links between which only links without collision geometry lie count as
adjacent, as do all links around one without collision geometry.

Sources:
    SRDF: https://wiki.ros.org/srdf
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.robot.adjacency import Adjacency
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="bad">
  <link name="base"/>
  <link name="arm">
    <collision><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <link name="hand"/>
  <joint name="shoulder" type="continuous">
    <parent link="base"/>
    <child link="arm"/>
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
  <disable_collisions link1="base" link2="hand" reason="Adjacent"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
</robot>
""",
}


@rule(
    "SRD008",
    "reason-adjacent-untrue",
    Severity.WARNING,
    needs=(Need.MODEL, Need.SRDF),
    help="compute the collision matrix anew, or give the true reason",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None:
        return
    adjacency = Adjacency(subject.tree)
    for pair in srdf.root.all("disable_collisions"):
        first, second = pair.get("link1") or "", pair.get("link2") or ""
        if (pair.get("reason") or "").lower() != "adjacent":
            continue
        known = {first, second} <= srdf.known("link")
        if known and not adjacency.is_adjacent(first, second):
            yield Finding(pair, f"no joint holds '{first}' and '{second}' together")

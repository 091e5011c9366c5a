"""The collision matrix lacks neighbours that overlap.

A joint holds the two links together, or only links without collision geometry lie between, and they
overlap where the robot begins. MoveIt checks them, finds the collision in every pose, and plans
nothing. The links or their geometry are newer than the matrix; `urdfkit collisions --srdf` brings
it up to date. An SRDF without any matrix is not reported.

Sources:
    MoveIt, URDF and SRDF: https://moveit.picknik.ai/main/doc/examples/urdf_srdf/urdf_srdf_tutorial.html
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="bad">
  <link name="base">
    <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
  </link>
  <link name="arm">
    <collision><geometry><cylinder radius="0.04" length="0.4"/></geometry></collision>
  </link>
  <link name="hand">
    <collision><geometry><sphere radius="0.1"/></geometry></collision>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <origin xyz="0 0 0.25"/>
    <axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
  <joint name="wrist" type="fixed">
    <parent link="arm"/>
    <child link="hand"/>
    <origin xyz="0 0 0.25"/>
  </joint>
</robot>
"""
GOOD = BAD.replace('"bad"', '"good"')
FILES = {
    "bad.srdf": b"""<robot name="bad">
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
</robot>
""",
    "good.srdf": b"""<robot name="good">
  <disable_collisions link1="base" link2="arm" reason="Adjacent"/>
  <disable_collisions link1="arm" link2="hand" reason="Adjacent"/>
</robot>
""",
}


#: In m: bodies that touch do not count.
_DEEP = 1e-4


@rule(
    "SRD010",
    "matrix-out-of-date",
    Severity.INFO,
    needs=(Need.MODEL, Need.SRDF, Need.COLLISIONS),
    help="bring it up to date: urdfkit collisions ROBOT --srdf FILE",
)
def check(subject: Subject) -> Iterator[Finding]:
    srdf = subject.srdf
    if srdf is None or not srdf.disabled or not subject.is_crowded:
        return
    for one in subject.collisions.in_moveit.meetings:
        pair = frozenset((one.small.link, one.large.link))
        held = one.is_adjacent or one.is_rigid
        if held and one.distance < -_DEEP and not srdf.disables(pair):
            first, second = sorted(pair)
            yield Finding(
                srdf.root,
                f"'{first}' and '{second}' are held together and overlap by "
                f"{-1000 * one.distance:.3g} mm, but their collisions are not disabled",
            )

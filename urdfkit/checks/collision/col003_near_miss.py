"""Two links pass within a millimetre of each other.

With all joints at zero, or with one of them at a limit, less than 1 mm is left between the two;
they collide in none of these poses. No robot is built to that, and no joint stops there: padding,
play, or a little overshoot makes it a collision. Keep the limit a little away from it, or make the
collision geometry say what is really there. Fingers that close on each other are meant to be near.

Sources:
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
<link name="base">
  <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
</link>
<link name="slider">
  <collision>
    <origin xyz="0.3 0 0.2"/>
    <geometry><box size="0.05 0.05 0.05"/></geometry>
  </collision>
</link>
<link name="drop">
  <collision><geometry><box size="0.05 0.05 0.05"/></geometry></collision>
</link>
<joint name="out" type="fixed">
  <parent link="base"/>
  <child link="slider"/>
</joint>
<joint name="down" type="prismatic">
  <parent link="slider"/>
  <child link="drop"/>
  <origin xyz="0 0 0.1255"/>
  <axis xyz="0 0 1"/>
  <limit lower="0" upper="0.1" effort="10" velocity="1"/>
</joint>"""
GOOD = BAD.replace("0 0 0.1255", "0 0 0.14")


@rule(
    "COL003",
    "near-miss",
    Severity.INFO,
    needs=(Need.MODEL, Need.COLLISIONS),
    help="keep the limit away from it, or correct the collision geometry",
)
def check(subject: Subject) -> Iterator[Finding]:
    if not subject.is_crowded or subject.is_part:
        return
    for near in subject.collisions.still.near_misses:
        pose = ", ".join(f"{name} {at:.3g}" for name, at in near.pose.items() if at)
        yield Finding(
            subject.model.links_by_name[near.second].at,
            f"links '{near.first}' and '{near.second}' come within "
            f"{1000 * near.distance:.2g} mm at {pose or 'zero'}",
            alike="near",
        )

"""Two links overlap in every pose.

They are neither neighbours nor held together by fixed joints, and collide at zero, at all limits
and in some dozens of poses between. The collision geometry is coarser than the robot, or one part
runs through another. MoveIt can plan only when the pair is disabled in the SRDF (`urdfkit
collisions --srdf`); a simulator with self-collision on pushes the parts apart all the time.

Sources:
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="body">
  <collision><geometry><cylinder radius="0.2" length="0.6"/></geometry></collision>
</link>
<link name="leg">
  <collision><geometry><box size="0.1 0.2 0.6"/></geometry></collision>
</link>
<link name="head">
  <collision><geometry><sphere radius="0.2"/></geometry></collision>
</link>
<joint name="hip" type="fixed">
  <parent link="body"/>
  <child link="leg"/>
  <origin xyz="0 0.22 0.15"/>
</joint>
<joint name="neck" type="continuous">
  <parent link="body"/>
  <child link="head"/>
  <origin xyz="0 0 0.3"/>
  <axis xyz="0 0 1"/>
</joint>"""
GOOD = BAD.replace("0 0.22 0.15", "0 0.22 -0.3")


@rule(
    "COL002",
    "always-colliding-pair",
    Severity.INFO,
    needs=(Need.MODEL, Need.COLLISIONS),
    help="make the collision geometry smaller, or disable the pair in the SRDF",
)
def check(subject: Subject) -> Iterator[Finding]:
    if not subject.is_crowded or subject.is_part:
        return
    still = subject.collisions.still
    for one in still.meetings:
        loose = not (one.is_adjacent or one.is_rigid or one.is_contained)
        if loose and one.distance < 0 and still.always(one):
            small, large = (subject.model.collision(*body) for body in one.bodies)
            yield Finding(
                small,
                f"links '{one.small.link}' and '{one.large.link}' overlap in every pose, by "
                f"{-1000 * one.distance:.3g} mm {still.beginning}",
                related=(Related(large.span, f"link '{one.large.link}'"),),
                weight=-one.distance,
                alike="overlap",
            )

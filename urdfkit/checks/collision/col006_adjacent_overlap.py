"""Two links that a joint holds together overlap with most of the smaller one.

Where collision geometry is simplified, neighbours may overlap a little at the joint. Here most of a
body is in the other one: a wheel deep in the box of the chassis, say. Gazebo, MuJoCo and MoveIt let
neighbours pass through each other, so that nothing happens between them. But the outer geometry
stands in the way of what should meet the inner one, such as a kerb of the wheel, and the box is
hardly the shape that was meant. Only primitives and convex meshes are reported, since their depth
is certain.

Sources:
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
    MuJoCo, URDF: https://mujoco.readthedocs.io/en/stable/modeling.html#urdf-extensions
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="chassis">
  <collision><geometry><box size="0.6 0.4 0.1"/></geometry></collision>
</link>
<link name="wheel">
  <collision>
    <origin rpy="1.5708 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </collision>
</link>
<joint name="axle" type="continuous">
  <parent link="chassis"/>
  <child link="wheel"/>
  <origin xyz="0.15 0.19 0"/>
  <axis xyz="0 1 0"/>
</joint>"""
GOOD = BAD.replace("0.15 0.19 0", "0.15 0.23 0")

#: Of the thickness of the smaller body: wheels of real robots often stand half in the chassis.
_PART = 0.6


@rule(
    "COL006",
    "adjacent-overlap",
    Severity.INFO,
    needs=(Need.MODEL, Need.COLLISIONS),
    help="make one of the two smaller, or move it",
)
def check(subject: Subject) -> Iterator[Finding]:
    if not subject.is_crowded or subject.is_part:
        return
    for one in subject.collisions.still.meetings:
        held = one.is_adjacent and not one.is_rigid and not one.is_contained
        if held and one.is_solid and one.part > _PART:
            small, large = (subject.model.collision(*body) for body in one.bodies)
            # A body moved out sideways goes farther than its thickness.
            part = "all" if one.part >= 1 else f"{one.part:.0%}"
            yield Finding(
                small,
                f"link '{one.small.link}' overlaps its neighbour '{one.large.link}' by "
                f"{-1000 * one.distance:.3g} mm, {part} of its thickness",
                related=(Related(large.span, f"link '{one.large.link}'"),),
                weight=-one.distance,
                alike="overlap",
            )

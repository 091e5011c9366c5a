"""All collision geometry of a moving link is inside that of another link.

Nothing can ever touch it from outside: a wheel within the chassis does not reach the floor, a
bumper or a finger feels nothing. In a simulator with self-collision on, the two push against each
other without end. Make the outer geometry smaller, or move the inner one to where the part is.

Sources:
    MoveIt, compute_default_collisions.cpp: https://github.com/moveit/moveit2/blob/main/moveit_setup_assistant/moveit_setup_srdf_plugins/src/compute_default_collisions.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Related, Severity
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="hand">
  <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
</link>
<link name="finger">
  <collision><geometry><sphere radius="0.02"/></geometry></collision>
</link>
<joint name="slide" type="prismatic">
  <parent link="hand"/>
  <child link="finger"/>
  <origin xyz="0 0 0.05"/>
  <axis xyz="1 0 0"/>
  <limit lower="0" upper="0.03" effort="20" velocity="0.1"/>
</joint>"""
GOOD = BAD.replace("0 0 0.05", "0 0 0.12")


@rule(
    "COL004",
    "swallowed-body",
    Severity.WARNING,
    needs=(Need.MODEL, Need.COLLISIONS),
    help="make the outer geometry smaller, or move the inner one to where the part is",
)
def check(subject: Subject) -> Iterator[Finding]:
    if not subject.is_crowded or subject.is_part:
        return
    still = subject.collisions.still
    for one in still.meetings:
        if one.is_swallowed and not one.is_rigid and still.always(one):
            small, large = (subject.model.collision(*body) for body in one.bodies)
            yield Finding(
                small,
                f"link '{one.small.link}' is inside the collision geometry of "
                f"'{one.large.link}': nothing can touch it",
                related=(Related(large.span, f"link '{one.large.link}'"),),
                alike=one.large.link,
            )

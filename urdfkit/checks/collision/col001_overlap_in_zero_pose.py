"""Two links overlap where all joints are at zero.

They are neither neighbours nor held together by fixed joints, and some poses of the robot part
them. Yet it begins in a collision: MoveIt refuses to plan from there, and a simulator with self-
collision on throws the parts against each other in its first step. Links above which a joint cannot
be at zero are passed over: such a robot begins in a pose of its own. Correct the origin of a joint
or of a collision, make the collision geometry smaller, or begin in another pose. An overlap of less
than 1 mm is taken for a closed gripper.

Sources:
    MoveIt, check_start_state_collision.cpp: https://github.com/moveit/moveit2/blob/main/moveit_ros/planning/planning_request_adapter_plugins/src/check_start_state_collision.cpp
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
<link name="base">
  <collision><geometry><box size="0.2 0.2 0.2"/></geometry></collision>
</link>
<link name="upper">
  <collision>
    <origin xyz="0 0 0.25"/>
    <geometry><box size="0.05 0.05 0.4"/></geometry>
  </collision>
</link>
<link name="tool">
  <collision>
    <origin xyz="0 0 -0.4"/>
    <geometry><sphere radius="0.05"/></geometry>
  </collision>
</link>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="upper"/>
  <origin xyz="0 0 0.1"/>
  <axis xyz="0 1 0"/>
  <limit lower="-1" upper="1" effort="10" velocity="1"/>
</joint>
<joint name="elbow" type="revolute">
  <parent link="upper"/>
  <child link="tool"/>
  <origin xyz="0.06 0 0.4"/>
  <axis xyz="0 1 0"/>
  <limit lower="-2" upper="2" effort="10" velocity="1"/>
</joint>"""
GOOD = BAD.replace("0 0 -0.4", "0 0 0.4")

#: In m: closed fingers of real grippers overlap by 0.3 mm.
_DEEP = 1e-3


@rule(
    "COL001",
    "overlap-in-zero-pose",
    Severity.WARNING,
    needs=(Need.MODEL, Need.COLLISIONS),
    help="correct an origin or the collision geometry, or begin in another pose",
)
def check(subject: Subject) -> Iterator[Finding]:
    if not subject.is_crowded or subject.is_part:
        return
    still = subject.collisions.still
    for one in still.meetings:
        loose = not (one.is_adjacent or one.is_rigid) and still.is_at_zero(one)
        if loose and one.distance < -_DEEP and not still.always(one):
            small, large = (subject.model.collision(*body) for body in one.bodies)
            yield Finding(
                small,
                f"links '{one.small.link}' and '{one.large.link}' overlap by "
                f"{-1000 * one.distance:.3g} mm where all joints are at zero",
                related=(Related(large.span, f"link '{one.large.link}'"),),
                weight=-one.distance,
                alike="overlap",
            )

"""A collision mesh is made of pieces with much empty space between them.

MuJoCo, Drake, Isaac and MoveIt's Bullet take the convex hull of a mesh, which fills that space: a
gripper can then grasp nothing, and a frame has no opening. Give each piece a `<collision>` of its
own, or let `urdfkit mesh decompose` do it.

Sources:
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    MoveIt, bullet_utils.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/collision_detection_bullet/src/bullet_integration/bullet_utils.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <collision>
    <geometry><mesh filename="forearm.stl"/></geometry>
  </collision>
</link>"""
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.stl": stl([*box((0, 0, 0), (0.01, 0.1, 0.3)), *box((0.2, 0, 0), (0.21, 0.1, 0.3))]),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH023",
    "several-bodies",
    Severity.INFO,
    needs=(Need.MODEL, Need.MESHES),
    help="give each piece a <collision> of its own (urdfkit mesh decompose)",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.measured.diagnoses.get("MSH023", ()):
        found = use.measures
        assert found.solid is not None
        assert found.hull is not None
        yield Finding(
            use.at,
            f"{use.who} has {found.bodies} pieces; its convex hull, which several simulators take, "
            f"has {found.hull.volume / found.solid.volume:.2g} times their volume",
            alike="pieces",
        )

"""A collision mesh has very many triangles.

Simulators and planners test it thousands of times a second. Over some 20 000 triangles a simulation
falls behind real time, MoveIt plans in seconds instead of milliseconds, and loading takes long;
MuJoCo refuses more than 200 000. A box, a cylinder or a convex hull does the same job: `urdfkit
mesh collision` finds the best, `urdfkit mesh simplify` keeps the shape with fewer triangles.

Sources:
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    RobotLocomotion/drake#13125: https://github.com/RobotLocomotion/drake/issues/13125
    measured: 49 of 1 513 public collision meshes have more than 20 000 triangles
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.assets.mesh_diagnoses import DENSE_COLLISION, MUJOCO_MOST
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
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3)), copies=1700),
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH019",
    "dense-collision-mesh",
    Severity.WARNING,
    needs=(Need.MODEL, Need.MESHES),
    help="urdfkit mesh collision or urdfkit mesh simplify makes a lighter one",
    options={"triangles": DENSE_COLLISION},
)
def check(subject: Subject) -> Iterator[Finding]:
    bound = check.option(subject, "triangles")
    dense = {
        use.path: use
        for use in reversed(subject.measured.files)
        if use.role == "collision" and use.measures.triangles > bound
    }
    for use in sorted(dense.values(), key=lambda use: -use.measures.triangles):
        number = use.measures.triangles
        refused = f", and MuJoCo rejects more than {MUJOCO_MOST:,}" if number > MUJOCO_MOST else ""
        yield Finding(
            use.at,
            f"{use.who} has {number:,} triangles; more than {bound:,} make collision "
            f"checking slow{refused}",
            weight=number,
            alike="dense",
        )

"""A mesh has a vertex that is not a number, or infinite.

Some readers drop the triangle in silence, others draw a spike to nowhere; a physics engine that
meets it in a collision shape loses the whole body. It comes from a division by zero in whatever
wrote the mesh: export it again, or remove the triangle in a mesh editor.

Sources:
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="meshes/spike.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("spike", "plate")

FILES = {
    "meshes/spike.stl": PLATE.replace(b"1 0 0", b"nan 0 0"),
    "meshes/plate.stl": PLATE,
}


@rule(
    "MSH026",
    "non-finite-vertices",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="export the mesh again, or remove the triangle in a mesh editor",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh in subject.files.meshes:
        if mesh.facts and mesh.facts.non_finite:
            yield Finding(mesh.at, f"{mesh.who} is not finite: {mesh.facts.non_finite}")

"""A mesh file is cut off, or holds more than it declares.

A download or an export broke off: a binary STL has fewer (or more) bytes than its number of
triangles asks for, a COLLADA file ends before its last tag, a PLY file has fewer faces than it
declares. Some readers refuse such a file, others load it in silence as nothing or in part. Fetch
or export the mesh again.

Sources:
    STL: https://en.wikipedia.org/wiki/STL_(file_format)
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.io.facts import DefectKind
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="meshes/half.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("half", "plate")

FILES = {"meshes/half.stl": PLATE[:70], "meshes/plate.stl": PLATE}


@rule(
    "MSH011",
    "truncated-mesh",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="fetch or export the mesh again",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh, reason in subject.files.with_defect(DefectKind.TRUNCATED):
        yield Finding(mesh.at, f"{mesh.who} {reason}")

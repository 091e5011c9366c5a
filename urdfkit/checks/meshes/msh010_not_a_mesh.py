"""A file that should be a mesh is something else.

Often it is a web page that was saved instead of the file it shows, or the pointer that Git LFS
leaves where `git lfs pull` has not been run; a picture, an archive or a text under the name of a
mesh do no better. Every reader fails on it, and few say why.

Sources:
    Git LFS, pointers: https://github.com/git-lfs/git-lfs/blob/main/docs/spec.md
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
    <geometry><mesh filename="meshes/hokuyo.dae"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("hokuyo.dae", "plate.stl")

FILES = {
    "meshes/hokuyo.dae": b"<!DOCTYPE html><html><title>hokuyo.dae</title></html>",
    "meshes/plate.stl": PLATE,
}


@rule(
    "MSH010",
    "not-a-mesh",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="fetch the file itself: from the raw link of the page, or with git lfs pull",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh, reason in subject.files.with_defect(DefectKind.NOT_A_MESH):
        pull = "run git lfs pull" if "Git LFS" in reason else ""
        yield Finding(mesh.at, f"{mesh.who} {reason}", pull, alike=pull)

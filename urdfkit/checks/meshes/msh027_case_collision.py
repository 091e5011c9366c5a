"""The names of two mesh files of a folder differ in upper and lower case only.

Linux keeps both. On Windows and macOS a clone of the repository, or an archive of it, has only one
of them, and whichever came last stands for both. Rename one.

Sources:
    git, core.ignoreCase: https://git-scm.com/docs/git-config
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
GOOD = BAD.replace("forearm.stl", "sub/hand.stl")
FILES = {
    "forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
    "Forearm.STL": stl(box((0, 0, 0), (0.1, 0.1, 0.2))),
    "sub/hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    "MSH027",
    "case-collision",
    Severity.WARNING,
    needs=(Need.MODEL, Need.FILES),
    help="rename one of the files",
)
def check(subject: Subject) -> Iterator[Finding]:
    for mesh, other in subject.files.case_collisions:
        yield Finding(
            mesh.at, f"{mesh.who} and '{other}' beside it differ in upper and lower case only"
        )

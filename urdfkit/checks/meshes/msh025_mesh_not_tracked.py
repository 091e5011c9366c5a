"""Git ignores a mesh file that the robot needs.

The robot works on this machine; a clone of the repository lacks the mesh. Most often a pattern for
the output of compilers, such as `*.obj`, or for large files, matches it. `git add -f` adds the
file; a line such as `!meshes/*.obj` in .gitignore is an exception for good.

Sources:
    gitignore: https://git-scm.com/docs/gitignore
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.robot.samples import mesh_xml
from urdfkit.text.diagnostic import Severity

BAD = mesh_xml("collision", "forearm.obj")
GOOD = BAD.replace("forearm.obj", "hand.stl")
FILES = {
    ".git/HEAD": b"ref: refs/heads/main\n",
    ".git/objects/info/keep": b"",
    ".git/refs/heads/keep": b"",
    ".gitignore": b"# compiler\n*.obj\n",
    "forearm.obj": b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
    "hand.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
}


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.FILES),
    help="git add -f FILE, and an exception in .gitignore",
)
def check(subject: Subject) -> Findings:
    for mesh in subject.files.ignored:
        yield Finding(mesh.at, f"{mesh.who} is ignored by git: clones of the repository lack it")

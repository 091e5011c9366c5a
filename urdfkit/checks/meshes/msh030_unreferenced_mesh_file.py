"""Mesh files lie beside those of the robot, and nothing in the workspace mentions them.

They are left over from an older version, or the robot should use one of them and names another.
They are installed, packed and cloned along. Delete them, or move the sources of a CAD program to a
folder of their own.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import box, stl
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="package://arm_description/meshes/forearm.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace(
    "</link>",
    """  <collision>
    <geometry><mesh filename="package://arm_description/meshes/forearm_old.stl"/></geometry>
  </collision>
</link>""",
)
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.3))),
    "meshes/forearm_old.stl": stl(box((0, 0, 0), (0.1, 0.1, 0.2))),
}

#: Names that a message holds.
_MOST = 5


@rule(
    "MSH030",
    "unreferenced-mesh-file",
    Severity.INFO,
    needs=(Need.MODEL, Need.FILES),
    help="delete them, or use them",
)
def check(subject: Subject) -> Iterator[Finding]:
    paths = subject.files.unreferenced
    if not paths:
        return
    names = [f"'{name}'" for name in _names(paths)[:_MOST]]
    more = f" and {len(paths) - _MOST} more" if len(paths) > _MOST else ""
    yield Finding(
        subject.model.root,
        f"no file of the workspace mentions {', '.join(names)}{more}, beside the meshes of this "
        "robot",
    )


def _names(paths: list[str]) -> list[str]:
    """Names of files, with their folder where one name stands for several."""
    names = [os.path.basename(path) for path in paths]
    return [
        os.path.join(os.path.basename(os.path.dirname(path)), name)
        if names.count(name) > 1
        else name
        for path, name in zip(paths, names, strict=True)
    ]

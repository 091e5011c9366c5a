"""A mesh file does not exist.

RViz shows the link white or not at all, and turns the robot's status red; Gazebo leaves the shape
out, so that a link without its collision falls through the floor; Pinocchio and MuJoCo refuse the
model. The package was found, the file in it was not: look for a slip in the name, a folder that
has moved, or a file that was never committed. A package that is not found is MSH005, a name that
differs only in upper and lower case MSH002.

Sources:
    RViz, robot_link.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/src/rviz_default_plugins/robot/robot_link.cpp
    Pinocchio, URDF geometry: https://github.com/stack-of-tasks/pinocchio/blob/devel/src/parsers/urdf/geometry.cpp
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    measured: 60 of 548 public models with meshes
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.workspace.resolve import ResolvedReference

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="package://arm_description/meshes/forarm.stl"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("forarm", "forearm")
FIXED = GOOD
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}


@rule(
    "MSH001",
    "missing-file",
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="put the file there, or make one: urdfkit mesh generate --model ROBOT",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    files = subject.files
    for mesh in files.missing:
        if files.spelt_on_disk(mesh):
            continue
        located = mesh.located
        where = f" in package '{located.package}'" if located.package else ""
        # An absolute path is what was tried.
        tried = "" if located.scheme == "absolute" else f"; tried {located.attempts}"
        message = f"{mesh.who} does not exist{where}{tried}"
        suggested = files.nearest(mesh)
        if suggested is None:
            yield Finding(mesh.at, message, alike=_lost_folder(located))
            continue
        edits = (
            replace_value(mesh.literal, suggested.reference)
            if mesh.literal and suggested.sure
            else None
        )
        fix = Fix.of(f"refer to {suggested.reference}", edits)
        yield Finding(
            mesh.at,
            message,
            f"did you mean '{suggested.reference}'?",
            fix,
            alike=f"{'mended' if fix else 'offered'} {_lost_folder(located)}",
        )


def _lost_folder(located: ResolvedReference) -> str:
    """The topmost folder that is not there; the file's own if that is there."""
    lost = os.path.dirname(os.path.abspath(located.tried[0]))
    while not os.path.isdir(above := os.path.dirname(lost)):
        lost = above
    return lost

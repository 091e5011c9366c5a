"""A COLLADA file is not in metres, and its readers disagree what that means.

`<unit meter="0.001"/>` at the top of the file says that its lengths are in millimetres. RViz and
Gazebo multiply by it; MoveIt, Pinocchio, coal and most Python tools do not. So the robot looks
right and its planner avoids something a thousand times as large, or the other way round. Bake the
unit into the vertices, with `urdfkit mesh convert`; then all readers agree. A mesh that is only
drawn is right in RViz and Gazebo, and an information; a warning if Pinocchio is a target.

Sources:
    COLLADA 1.4: https://www.khronos.org/files/collada_spec_1_4.pdf
    ros-visualization/rviz#1045: https://github.com/ros-visualization/rviz/issues/1045
    moveit/geometric_shapes#52: https://github.com/moveit/geometric_shapes/issues/52
    mikedh/trimesh#1083: https://github.com/mikedh/trimesh/issues/1083
    measured: 23 of 517 public files
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.mesh.io.facts import has_other_unit
from urdfkit.mesh.samples import collada
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="arm">
  <visual>
    <geometry><mesh filename="forearm.dae"/></geometry>
  </visual>
</link>"""
GOOD = BAD.replace("forearm", "hand")
FILES = {
    "forearm.dae": collada('<unit name="millimeter" meter="0.001"/>'),
    "hand.dae": collada('<unit name="meter" meter="1"/>'),
}


@rule(
    "MSH013",
    "collada-unit-not-metre",
    Severity.WARNING,
    needs=(Need.MODEL, Need.FILES),
    help="bake it: urdfkit mesh convert FILE NEW.dae",
)
def check(subject: Subject) -> Iterator[Finding]:
    collided = {mesh.located.path for mesh in subject.files.meshes if mesh.role == "collision"}
    for mesh in subject.files.each_file:
        if mesh.facts and has_other_unit(mesh.facts):
            is_drawn = (
                mesh.located.path not in collided and "pinocchio" not in subject.targets.names
            )
            yield Finding(
                mesh.at,
                f"{mesh.who} says that its unit is {mesh.facts.unit:g} m: RViz and Gazebo multiply "
                "by it, MoveIt, Pinocchio and coal do not",
                alike=f"{mesh.facts.unit:g}",
                severity=Severity.INFO if is_drawn else None,
            )

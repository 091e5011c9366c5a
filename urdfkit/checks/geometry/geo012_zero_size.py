"""A shape has no extent in some direction.

A size of 0 is often written to mean "no shape here". RViz draws nothing, Gazebo and Drake take it
for a point; MuJoCo refuses the robot, and some collision engines divide by the volume. Leave the
whole `<visual>` or `<collision>` out: a link without one is allowed.

Sources:
    MuJoCo, user_objects.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_objects.cc
    Drake, URDF geometry: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_geometry.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.shapes import shaped, sizes
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="tool">
  <collision>
    <geometry><box size="0 0 0"/></geometry>
  </collision>
</link>"""
GOOD = '<link name="tool"/>'


@rule(
    "GEO012",
    "zero-size",
    Severity.INFO,
    help="leave the whole <visual> or <collision> out",
    by_target={"mujoco": Severity.ERROR},
)
def check(subject: Subject) -> Iterator[Finding]:
    for link, body, shape in shaped(subject.model):
        for attribute, values in sizes(shape):
            if min(values) == 0:
                yield Finding(
                    attribute,
                    f"link '{link.name}': the <{shape.kind}> in its {body.at.tag} has "
                    f"{attribute.name} {' '.join(f'{value:g}' for value in values)} m",
                )

"""A material of Gazebo Classic does nothing in the Gazebo that the robot is for.

Gazebo Fortress has no material scripts at all, and from Garden on gz-sim substitutes the plain
colours by name but draws no texture. For these, give the colour in the URDF's `<material>` or as
`<visual><material><diffuse>` in the `<gazebo>` block.

Sources:
    gz-sim, migration of materials: https://github.com/gazebosim/gz-sim/blob/main/tutorials/migration_sdf.md
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.materials import materials
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="wheel">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="wheel">
  <material>Gazebo/Orange</material>
</gazebo>
<gazebo>
  <plugin name="ignition::gazebo::systems::PosePublisher"
          filename="ignition-gazebo-pose-publisher-system"/>
</gazebo>"""
GOOD = BAD.replace("<material>Gazebo/Orange</material>", "<mu1>0.8</mu1>")


@rule(
    "GAZ008",
    "material-without-effect",
    Severity.INFO,
    help="give the colour in the URDF's <material>",
    by_target={"gz-fortress": Severity.INFO},
)
def check(subject: Subject) -> Iterator[Finding]:
    targets = subject.targets
    fortress = targets.any_of(("gz-fortress",))
    if not fortress and not targets.any_of(("gz-harmonic", "gz-jetty")):
        return
    for block in subject.model.gazebo:
        for child in block.all("material") if block.get("reference") else ():
            known = materials().get(child.get("value") or child.text.strip())
            if known is None:
                continue
            if fortress:
                message = f"Gazebo Fortress has no material scripts: '{known.name}' does nothing"
                yield Finding(child, message)
            elif known.textured:
                yield Finding(child, f"gz-sim does not draw the texture of '{known.name}'")

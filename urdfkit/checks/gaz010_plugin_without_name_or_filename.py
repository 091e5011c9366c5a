"""A plugin has no `name`, or no `filename`.

SDF requires both: up to SDF 1.9 Gazebo refuses the whole model without them. The file name is that
of the library; the name is free in Gazebo Classic and the class in gz-sim.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, Need, rule

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin filename="libgazebo_ros_planar_move.so"/>
</gazebo>"""
GOOD = BAD.replace("<plugin", '<plugin name="drive"')


@rule(
    "GAZ010",
    "plugin-without-name-or-filename",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        for attribute, what in (("name", "name"), ("filename", "file name of its library")):
            if not (use.at.get(attribute) or "").strip():
                other = use.filename if attribute == "name" else f"'{use.name}'"
                message = f"plugin {other} has no {attribute}: Gazebo refuses the model"
                yield Finding(use.at, message, f'add {attribute}="...", the {what}')

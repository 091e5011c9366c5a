"""A system of the world stands in the robot.

Sensors, physics and the like are systems of gz-sim that a world has once. With the robot's own copy
beside that of the world, every sensor is made twice, and rendering crashes; and two robots bring
two copies. Put it in the world, or give the robot a world without it and say so.

Sources:
    gazebosim/gz-sensors#497: https://github.com/gazebosim/gz-sensors/issues/497
    Gazebo, system plugins: https://github.com/gazebosim/gz-sim/blob/main/tutorials/adding_system_plugins.md
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="gz::sim::systems::Sensors" filename="gz-sim-sensors-system"/>
</gazebo>"""
GOOD = BAD.replace("systems::Sensors", "systems::PosePublisher").replace(
    "gz-sim-sensors", "gz-sim-pose-publisher"
)


@rule(
    "GAZ033",
    "world-system-in-model",
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="put it in the world file",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        if use.plugin and use.plugin.kinds == ("world",) and use.plugin.generation == "gz":
            message = f"{use.title} is a system of the world, which has it once for all robots"
            yield Finding(use.at, message)

"""One robot has plugins of different generations of Gazebo.

No Gazebo loads both: each writes errors about the other's libraries, and half of the robot's
sensors or drives is missing in every one of them. Choose one, or select the block with a xacro
argument (`<xacro:if value="$(arg use_gz)">`).

Sources:
    Gazebo, migration from Classic: https://gazebosim.org/docs/latest/migrating_gazebo_classic_ros2_packages/
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/main/src/SystemLoader.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.catalog.plugins import GENERATIONS, TITLES
from urdfkit.ros.gazebo.plugins import PluginUse, generations
from urdfkit.text.diagnostic import Related, Severity

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
  <plugin name="drive" filename="libgazebo_ros_planar_move.so"/>
  <plugin name="gz::sim::systems::PosePublisher" filename="gz-sim-pose-publisher-system"/>
</gazebo>"""
GOOD = BAD.replace(
    '  <plugin name="gz::sim::systems::PosePublisher" filename="gz-sim-pose-publisher-system"/>\n',
    "",
)


@rule(
    "GAZ013",
    "mixed-generations",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    help="keep the plugins of one, or choose between them with a xacro argument",
)
def check(subject: Subject) -> Iterator[Finding]:
    wanted = [GENERATIONS[name][0] for name in subject.targets.names if name in GENERATIONS]
    if len(set(wanted)) == 1 and not subject.targets.evidence:
        return  # the target is given, and GAZ012 tells what is not of it
    first: PluginUse | None = None
    common: set[str] = set()
    for use in subject.plugins:
        possible = generations(use)
        if not possible:
            continue
        if first is None:
            first, common = use, possible
        elif not common & possible:
            yield Finding(
                use.at.attributes["filename"],
                f"{use.title} is for {_named(possible)}, and {first.title} for {_named(common)}",
                related=(Related(first.at.span, f"a plugin of {_named(common)}"),),
            )
            return
        else:
            common = common & possible


def _named(possible: set[str]) -> str:
    return " or ".join(TITLES[name] for name in sorted(possible))

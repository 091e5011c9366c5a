"""A plugin is given the name of a link that the robot does not have.

The plugin looks the link up in the simulated model; not finding it, it writes an error and stays
idle, and some plugins end the simulator. Xacro prefixes are a usual cause.

Sources:
    ros-simulation/gazebo_ros_pkgs#843: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/843
    osrf/vrx#867: https://github.com/osrf/vrx/issues/867
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Fix, Severity
from urdfkit.editing.edits import rewrite
from urdfkit.nearest import Speller
from urdfkit.rules import Finding, Need, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.gazebo.plugins import Reference
    from urdfkit.subject import Subject

BAD = """\
<link name="arm_link">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="pose" filename="libgazebo_ros_p3d.so">
    <bodyName>arm_lnk</bodyName>
    <topicName>arm_pose</topicName>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("arm_lnk", "arm_link")
FIXED = GOOD


@rule(
    "GAZ020",
    "parameter-names-unknown-link",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="name a link of this robot",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    known = {*subject.model.links_by_name, *subject.gazebo.added, "world"}
    speller = Speller(subject.model.links_by_name)
    for use in subject.plugins:
        for reference in use.references():
            if reference.kind != "link" or reference.name in known:
                continue
            if subject.is_part:  # the file that includes it has the link
                return
            meant = speller.meant(reference.name)
            outcome = f": {use.plugin.missing}" if use.plugin and use.plugin.missing else ""
            yield Finding(
                reference.item.at,
                f"{use.title} looks for link '{reference.name}', which does not exist{outcome}",
                f"did you mean '{meant}'?" if meant else "",
                _fix(reference, meant) if meant else None,
            )


def _fix(reference: Reference, meant: str) -> Fix | None:
    at, name = reference.item.at, reference.name
    edits = rewrite(at, meant) if reference.item.text == name else None
    return Fix.of(f"rename '{name}' to '{meant}'", edits)

"""The library of a plugin is in no catalogue of this program.

It is a vendor's, and nothing more can be said about it; or it is not installed anywhere, and Gazebo
goes on without it. What is nearly the name of a known one is GAZ070's.

Sources:
    measured: half of the 66 plugins that 213 public models use are a vendor's
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.catalog.plugins import misspelt
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
  <plugin name="drive" filename="libour_omni_drive.so"/>
</gazebo>"""
GOOD = BAD.replace("our_omni_drive", "gazebo_ros_planar_move")


@rule(
    "GAZ011",
    "unknown-plugin",
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="if it is a vendor's, see that its package is a dependency of yours",
)
def check(subject: Subject) -> Iterator[Finding]:
    reported: set[str] = set()
    for use in subject.plugins:
        name = use.filename
        if use.known or not name or name in reported or misspelt(name):
            continue
        reported.add(name)  # one robot may use a library a hundred times
        yield Finding(
            use.at.attributes["filename"],
            f"'{name}' is not a plugin of Gazebo or ROS that is known here",
        )

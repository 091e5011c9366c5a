"""The library of a plugin is nearly one that Gazebo or ROS has.

Gazebo looks for a library of exactly that name, finds none, says so among other messages of its
start, and goes on without it: the robot does not drive, the sensor is not published. A name that is
further from all known ones is taken for a vendor's (GAZ011).

Sources:
    gazebo-classic, Plugin.hh: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/common/Plugin.hh
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/gz-sim8/src/SystemLoader.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.catalog.plugins import misspelt
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

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
  <plugin name="drive" filename="libgazebo_ros_planar_mvoe.so"/>
</gazebo>"""
GOOD = BAD.replace("mvoe", "move")
FIXED = GOOD


@rule(
    "GAZ070",
    "plugin-misspelt",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        suggested = misspelt(use.filename) if use.filename and not use.known else ""
        if suggested:
            at = use.at.attributes["filename"]
            yield Finding(
                at,
                f"{use.title}: '{use.filename}' is nearly '{suggested}'; Gazebo finds no such "
                "library",
                f"write {suggested}",
                Fix.of(f"write {suggested}", replace_value(at, suggested)),
                alike=suggested,
            )

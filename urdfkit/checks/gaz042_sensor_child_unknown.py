"""A sensor has a child that no sensor has.

Gazebo prints a warning and passes over it, so the setting that it was meant for keeps its default.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.catalog.sensors import children
from urdfkit.diagnostic import Severity
from urdfkit.nearest import did_you_mean
from urdfkit.rules import Finding, rule
from urdfkit.sensors import sensors

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="eye" type="imu">
    <updat_rate>100</updat_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("updat_rate", "update_rate")


@rule(
    "GAZ042",
    "sensor-child-unknown",
    Severity.WARNING,
    help="mend the name of the tag",
)
def check(subject: Subject) -> Iterator[Finding]:
    known = children()
    for sensor in sensors(subject.model):
        for child in sensor.at.children:
            if child.tag not in known and ":" not in child.tag:
                hint = did_you_mean(child.tag, known)
                yield Finding(child, f"{sensor.who}: a sensor has no <{child.tag}>{hint}")

"""Two sensors of one link have the same name.

gz-sim refuses the model ("non-unique name"), Gazebo Classic makes one of the two. Links that fixed
joints hold together count as one, since Gazebo merges them.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    sdformat, Sensor.cc: https://github.com/gazebosim/sdformat/blob/main/src/Sensor.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.gazebo.sensors import Sensor, sensors
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
<gazebo reference="base">
  <sensor name="eye" type="imu"/>
  <sensor name="eye" type="camera"/>
</gazebo>"""
GOOD = BAD.replace('"eye" type="imu"', '"balance" type="imu"')


@rule(
    "GAZ061",
    "duplicate-sensor-name",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="give each a name of its own",
)
def check(subject: Subject) -> Iterator[Finding]:
    first: dict[tuple[str, str], Sensor] = {}
    for sensor in sensors(subject.model):
        if not sensor.name or not sensor.reference:
            continue
        link = subject.gazebo.survivor.get(sensor.reference, sensor.reference)
        other = first.setdefault((link, sensor.name), sensor)
        if other is not sensor:
            merged = f", which Gazebo makes part of '{link}'" if link != sensor.reference else ""
            yield Finding(
                sensor.at.attributes["name"],
                f"{sensor.who} on '{sensor.reference}'{merged} has the name of another one there",
                related=(Related(other.at.span, "the other one"),),
            )

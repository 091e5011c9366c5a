"""A sensor has no name.

SDF demands one: gz-sim and Gazebo Classic refuse the whole model.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.gazebo.sensors import sensors
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
<gazebo reference="base">
  <sensor type="imu">
    <update_rate>100</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("<sensor ", '<sensor name="imu" ')


@rule("GAZ060", "sensor-without-name", Severity.ERROR, help='add name="...", unique in the link')
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        if not sensor.name.strip():
            kind = f" of type '{sensor.type}'" if sensor.type else ""
            who = f"a sensor{kind} on '{sensor.reference}'"
            yield Finding(sensor.at, f"{who} has no name: Gazebo refuses the model")

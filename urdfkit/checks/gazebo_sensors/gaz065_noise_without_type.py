"""The noise of a sensor has no type where Gazebo insists on one.

The noise of pictures and scans has its type in a child, `<type>gaussian</type>`. That of an IMU, a
GPS, a magnetometer, an altimeter, a pressure or force sensor has it in an attribute, `<noise
type="gaussian">`, and SDF requires it: without it the whole model is refused. It happens where the
block of a lidar is copied into an IMU.

Sources:
    SDF, noise: http://sdformat.org/spec?ver=1.9&elem=sensor
    measured: libsdformat 12.3 rejects the model
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.gazebo.sensors import sensors, written
from urdfkit.text.diagnostic import Edit, Fix, Severity
from urdfkit.text.source import Span

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.text.document import Element

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="imu" type="imu">
    <imu>
      <angular_velocity>
        <x>
          <noise>
            <mean>0</mean>
            <stddev>0.01</stddev>
          </noise>
        </x>
      </angular_velocity>
    </imu>
  </sensor>
</gazebo>"""
FIXED = GOOD = BAD.replace("<noise>", '<noise type="gaussian">')


@rule(
    "GAZ065",
    "noise-without-type",
    Severity.ERROR,
    help='write <noise type="gaussian">',
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        for inner in written(sensor):
            if inner.holds_type_as_attribute and "type" not in inner.at.attributes:
                child = inner.at.child("type")
                reported = ", and ignores its <type>" if child else ""
                yield Finding(
                    inner.at,
                    f"{sensor.who}: <noise> has no attribute type: Gazebo rejects the model"
                    f"{reported}",
                    fix=_typed(inner.at, child.text.strip() if child else "gaussian"),
                )


def _typed(noise: Element, type: str) -> Fix:
    source, _, end = noise.tag_at.name_span
    return Fix(f'write <noise type="{type}">', (Edit(Span(source, end, end), f' type="{type}"'),))

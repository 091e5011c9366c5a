"""A sensor makes more than a hundred million values a second.

Rendering that many pixels or casting that many rays takes more than a usual computer has, and the
simulation falls behind real time. Lower the resolution or the rate while you do not need them.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
"""

from __future__ import annotations

from math import prod

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.diagnostic import Severity

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="camera" type="camera">
    <update_rate>60</update_rate>
    <camera><image><width>1920</width><height>1080</height></image></camera>
  </sensor>
</gazebo>"""
GOOD = BAD.replace(">60<", ">10<")

#: Values a second. A camera of 1920 x 1080 at 30 Hz makes 6e7, which a usual computer renders.
_HEAVY = 1e8
_WAYS = ("horizontal", "vertical")


@rule(Severity.INFO, help="lower the resolution or the update rate")
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        rate = sensor.number("update_rate")
        amount = _values(sensor)
        if rate is not None and rate.value * amount > _HEAVY:
            yield Finding(
                rate,
                f"{sensor.who}: {amount:.0f} values {rate.value:g} times a second are "
                f"{rate.value * amount / 1e6:.4g} million a second, more than {_HEAVY / 1e6:g}",
            )


def _values(sensor: Sensor) -> float:
    """Pixels of a picture, or beams of a scan."""
    if sensor.lidar:
        counts = (sensor.number(f"{sensor.lidar}/scan/{way}/samples") for way in _WAYS)
    else:
        counts = (sensor.number(f"camera/image/{way}") for way in ("width", "height"))
    values = [count.value for count in counts if count is not None]
    return prod(values) if values else 0.0

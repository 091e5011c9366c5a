"""A sensor makes more than fifty million values a second.

Rendering that many pixels or casting that many rays takes more than a usual computer has, and the
simulation falls behind real time. Lower the resolution or the rate while you do not need them.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import prod
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, rule
from urdfkit.sensors import Sensor, sensors

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base"/>
<gazebo reference="base">
  <sensor name="eye" type="camera">
    <update_rate>60</update_rate>
    <camera><image><width>1920</width><height>1080</height></image></camera>
  </sensor>
</gazebo>"""
GOOD = BAD.replace(">60<", ">10<")

#: Values a second; a 1280 x 720 camera at 50 Hz makes 4.6e7.
_HEAVY = 5e7
_WAYS = ("horizontal", "vertical")


@rule(
    "GAZ054",
    "heavy-sensor",
    Severity.INFO,
    help="lower the resolution or the update rate",
)
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        rate = sensor.number("update_rate")
        amount = _values(sensor)
        if rate is not None and rate.value * amount > _HEAVY:
            message = f"{sensor.who}: {amount:g} values {rate.value:g} times a second"
            yield Finding(rate, f"{message} are {rate.value * amount:.2g} a second")


def _values(sensor: Sensor) -> float:
    """Pixels of a picture, or beams of a scan."""
    if sensor.lidar:
        counts = (sensor.number(f"{sensor.lidar}/scan/{way}/samples") for way in _WAYS)
    else:
        counts = (sensor.number(f"camera/image/{way}") for way in ("width", "height"))
    values = [count.value for count in counts if count is not None]
    return prod(values) if values else 0.0

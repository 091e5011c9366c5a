"""A lidar's least range is not below its greatest.

No beam can ever hit anything: the lidar is blind, and navigation sees an empty world. Both are 0 if
they are not written.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gz-sensors, Lidar.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Lidar.cc
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.diagnostic import Fix, Severity
from urdfkit.editing.edits import swap
from urdfkit.gazebo.sensors import sensors
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

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
  <sensor name="eye" type="ray">
    <ray>
      <scan>
        <horizontal>
          <samples>360</samples>
          <min_angle>-1</min_angle>
          <max_angle>1</max_angle>
        </horizontal>
      </scan>
      <range><min>10</min><max>0.1</max></range>
    </ray>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("<min>10</min><max>0.1</max>", "<min>0.1</min><max>10</max>")
FIXED = GOOD


@rule(
    "GAZ046",
    "lidar-range-inverted",
    Severity.ERROR,
    help="let the least range be below the greatest",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        least = sensor.number(f"{sensor.lidar}/range/min")
        greatest = sensor.number(f"{sensor.lidar}/range/max")
        if sensor.lidar and least and greatest and least.value >= greatest.value:
            message = f"{sensor.who}: the least range {least.value:g} m is not below the greatest"
            message += f", {greatest.value:g} m"
            edits = swap(least.at, greatest.at)
            yield Finding(least, message, fix=Fix("swap the two", edits) if edits else None)

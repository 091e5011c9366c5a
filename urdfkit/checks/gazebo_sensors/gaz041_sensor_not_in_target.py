"""A sensor is of a type that the target does not make.

Gazebo Classic and gz-sim have different names for the same sensors: `ray` and `gpu_ray` became
`gpu_lidar`, `depth` became `depth_camera`, `gps` became `navsat`. The wrong one is passed over with
a line in the log, and no data ever come.

Sources:
    gz-sim, SdfEntityCreator.cc: https://github.com/gazebosim/gz-sim/blob/main/src/SdfEntityCreator.cc
    Gazebo Classic, SensorFactory.cc: https://github.com/gazebosim/gazebo-classic/blob/gazebo11/gazebo/sensors/SensorFactory.cc
    gazebosim/gz-sensors#26: https://github.com/gazebosim/gz-sensors/issues/26
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.sensors import types
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.ros.targets import CLASSIC, GAZEBO, GZ
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
  <sensor name="lidar" type="ray">
    <update_rate>10</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace('"ray"', '"imu"')


@rule(
    "GAZ041",
    "sensor-not-in-target",
    Severity.INFO,
    help="use the type that the target has",
    by_target=dict.fromkeys(GAZEBO, Severity.ERROR),
)
def check(subject: Subject) -> Iterator[Finding]:
    wants_gz = subject.targets.any_of(GZ)
    wants_classic = subject.targets.any_of(CLASSIC)
    for sensor in sensors(subject.model):
        kind = types().get(sensor.type)
        if kind is None:
            continue
        if not kind.gz and (wants_gz or not wants_classic):
            other = f"; there it is '{kind.gz_name}'" if kind.gz_name else ""
            at = sensor.at.attributes["type"]
            yield Finding(
                at, f"{sensor.who}: gz-sim makes no sensor of type '{sensor.type}'{other}"
            )
        elif not kind.classic and wants_classic:
            other = f"; there it is '{kind.classic_name}'" if kind.classic_name else ""
            message = f"{sensor.who}: Gazebo Classic makes no sensor of type '{sensor.type}'{other}"
            yield Finding(sensor.at.attributes["type"], message)

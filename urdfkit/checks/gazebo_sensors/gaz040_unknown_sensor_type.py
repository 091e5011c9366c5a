"""A sensor is of a type that no Gazebo knows.

The sensor is not made, and its topics never appear. Gazebo says so once in its log. The name is
misspelt, or it is that of a product instead of a kind of sensor. A type that is like no other, of a
sensor whose plugin is not known either, is taken for one that the plugin's own package brings.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    sdformat, Sensor.cc: https://github.com/gazebosim/sdformat/blob/main/src/Sensor.cc
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.sensors import types
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.catalog.sensors import SensorType
    from urdfkit.ros.gazebo.sensors import Sensor
    from urdfkit.ros.targets import Targets

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="lidar" type="lidr">
    <update_rate>10</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("lidr", "ray")
FIXED = BAD.replace("lidr", "lidar")

#: How like a type a word must be to be taken for a slip of it.
_TYPO = 0.8


@rule(
    "GAZ040",
    "unknown-sensor-type",
    Severity.ERROR,
    help="use a type that Gazebo knows, such as ray, gpu_lidar, camera, imu or contact",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    known = types()
    for sensor in sensors(subject.model):
        if sensor.type not in known and not _brings_its_type(sensor, known):
            at = sensor.at.attributes.get("type", sensor.at)
            what = f"of type '{sensor.type}', which" if sensor.type else "without a type, which"
            made = [name for name, one in known.items() if _is_made(one, subject.targets)]
            hint = did_you_mean(sensor.type, made)
            message = f"{sensor.who} is {what} no Gazebo knows{hint}"
            yield Finding(at, message, fix=_fix(sensor, made))


def _is_made(type: SensorType, targets: Targets) -> bool:
    """True if a Gazebo that the robot is for makes such sensors, or none is known."""
    gz = any(name.startswith("gz") for name in targets.names)
    classic = any(name.startswith("classic") for name in targets.names)
    return (type.gz and gz) or (type.classic and classic) or not (gz or classic)


def _brings_its_type(sensor: Sensor, known: Iterable[str]) -> bool:
    """True for a type of a foreign package, whose plugin stands in the sensor."""
    from urdfkit.ros.catalog.plugins import find  # loads the catalogue

    files = [(plugin.get("filename") or "").strip() for plugin in sensor.plugins]
    foreign = bool(files) and not any(map(find, files))
    return foreign and bool(sensor.type) and not nearest(sensor.type, known, _TYPO)


def _fix(sensor: Sensor, known: Iterable[str]) -> Fix | None:
    kind, suggested = sensor.at.attributes.get("type"), nearest(sensor.type, known, _TYPO)
    edits = replace_value(kind, suggested) if kind and suggested else None
    return Fix.of(f"write {suggested}", edits)

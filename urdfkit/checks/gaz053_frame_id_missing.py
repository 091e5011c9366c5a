"""A sensor of gz-sim does not say in which frame it measures.

Its messages are then stamped with a name of Gazebo's own, such as `robot/base_link/lidar`, which TF
does not know: RViz shows "frame does not exist". Name the link's frame with `<gz_frame_id>`.

Sources:
    gz-sensors, Sensor.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Sensor.cc
    gazebosim/gz-sensors#306: https://github.com/gazebosim/gz-sensors/issues/306
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.catalog.sensors import types
from urdfkit.diagnostic import Severity
from urdfkit.gazebo.sensors import Sensor, sensors
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

BAD = """\
<link name="base"/>
<gazebo reference="base">
  <sensor name="eye" type="imu">
    <update_rate>100</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("</update_rate>", "</update_rate><gz_frame_id>base</gz_frame_id>")

_GZ = ("gz-fortress", "gz-harmonic", "gz-jetty")
_TAGS = ("gz_frame_id", "frame_id", "ign_frame_id", "ignition_frame_id")


@rule(
    "GAZ053",
    "frame-id-missing",
    Severity.INFO,
    help="add <gz_frame_id>LINK</gz_frame_id> to the sensor",
    by_target=dict.fromkeys(_GZ, Severity.WARNING),
)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.targets.names and not subject.targets.any_of(_GZ):
        return
    without = [sensor for sensor in sensors(subject.model) if _nameless(sensor)]
    # One slip, made once by whoever wrote or generated the model: told where it begins.
    if without:
        more = f" (and {len(without) - 1} more likewise)" if len(without) > 1 else ""
        yield Finding(without[0].at, f"{without[0].who} names no frame for its measurements{more}")


def _nameless(sensor: Sensor) -> bool:
    if sensor.type == "contact":  # tells which bodies touch, not where it is
        return False
    kind = types().get(sensor.type)
    return (
        kind is not None and kind.gz and not any(sensor.at.child(tag) is not None for tag in _TAGS)
    )

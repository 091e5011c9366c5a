"""A sensor of gz-sim does not say in which frame it measures.

Its messages are then stamped with a name of Gazebo's own, such as `robot/base_link/lidar`, which TF
does not know: RViz shows "frame does not exist". Name the link's frame with `<gz_frame_id>`.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.catalog.sensors import types
from urdfkit.diagnostic import Severity
from urdfkit.rules import Finding, rule
from urdfkit.sensors import sensors

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
    for sensor in sensors(subject.model):
        kind = types().get(sensor.type)
        if (
            kind is None
            or not kind.gz
            or (subject.targets.names and not subject.targets.any_of(_GZ))
        ):
            continue
        if not any(sensor.at.child(tag) for tag in _TAGS):
            yield Finding(sensor.at, f"{sensor.who} names no frame for its measurements")

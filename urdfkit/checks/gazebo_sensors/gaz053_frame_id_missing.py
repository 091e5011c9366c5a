"""A sensor of gz-sim does not say in which frame it measures.

Its messages are then stamped with a name of Gazebo's own, such as `robot/base_link/lidar`, which TF
does not know: RViz shows "frame does not exist". Name the link's frame with `<gz_frame_id>`, which
all of them read. Fortress alone reads `<ignition_frame_id>`, too, and only Gazebo from Ionic on
(Jetty) reads `<frame_id>`. Without ROS there is no TF, and the finding is an info.

Sources:
    gz-sensors, Sensor.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Sensor.cc
    gazebosim/gz-sensors#306: https://github.com/gazebosim/gz-sensors/issues/306
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.sensors import types
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<gazebo reference="base">
  <sensor name="imu" type="imu">
    <update_rate>100</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("</update_rate>", "</update_rate><gz_frame_id>base</gz_frame_id>")

#: The tags by which each reads the frame.
_TAGS = {
    "gz-fortress": ("gz_frame_id", "ignition_frame_id"),
    "gz-harmonic": ("gz_frame_id",),
    "gz-jetty": ("gz_frame_id", "frame_id"),
}


@rule(
    "GAZ053",
    "frame-id-missing",
    Severity.INFO,
    help="add <gz_frame_id>LINK</gz_frame_id> to the sensor",
    by_target=dict.fromkeys(_TAGS, Severity.WARNING),
)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.targets.names and not subject.targets.any_of(_TAGS):
        return
    readers = [tags for target, tags in _TAGS.items() if subject.targets.any_of((target,))]
    without = [sensor for sensor in sensors(subject.model) if _is_nameless(sensor, readers)]
    # One slip, made once by whoever wrote or generated the model: told where it begins.
    if without:
        first = without[0]
        more = f" (and {len(without) - 1} more like this)" if len(without) > 1 else ""
        tags = _given(first)
        lack = f"names its frame by <{tags[0]}> only" if tags else "has no <gz_frame_id>"
        severity = None if _is_for_ros(subject) else Severity.INFO
        yield Finding(first.at, f"{first.who} {lack}{more}", severity=severity)


def _is_for_ros(subject: Subject) -> bool:
    targets = (subject.targets, subject.inferred_targets)
    return any(one.any_of(("ros1", "ros2")) for one in targets)


def _is_nameless(sensor: Sensor, readers: list[tuple[str, ...]]) -> bool:
    """True if one of the readers finds no frame; if none is known, nobody."""
    if sensor.type == "contact":  # tells which bodies touch, not where it is
        return False
    kind = types().get(sensor.type)
    if kind is None or not kind.gz:
        return False
    given = _given(sensor)
    return not given or any(set(tags).isdisjoint(given) for tags in readers)


def _given(sensor: Sensor) -> list[str]:
    """The tags of a frame that it has."""
    known = dict.fromkeys(tag for tags in _TAGS.values() for tag in tags)
    return [tag for tag in known if sensor.at.child(tag) is not None]

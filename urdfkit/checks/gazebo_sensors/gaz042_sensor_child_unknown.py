"""A sensor has a child that no sensor has, or its settings have one that SDF does not know there.

Gazebo prints a warning and passes over it, so the setting that it was meant for keeps its default:
a camera with a misspelt `<width>` makes pictures 320 pixels wide.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.sensors import children
from urdfkit.ros.gazebo.sensors import sensors, written
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rename_element

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
    <updat_rate>100</updat_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("updat_rate", "update_rate")
FIXED = GOOD

#: What is meant by a child that belongs elsewhere.
_INSTEAD = {
    "origin": "place it by <pose>x y z roll pitch yaw</pose>",
    "noise": "move it into <ray> or <camera>, or into <imu><angular_velocity><x>",
}

#: How like a tag a word must be to be taken for a slip of it.
_TYPO = 0.8


@rule(
    "GAZ042",
    "sensor-child-unknown",
    Severity.WARNING,
    help="fix the name of the element",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    known = children()
    for sensor in sensors(subject.model):
        for child in sensor.at.children:
            if child.tag not in known and ":" not in child.tag:
                yield _finding(child, sensor.who, "sensor", known)
        for inner in written(sensor):
            if inner.setting is None and ":" not in inner.at.tag:
                yield _finding(inner.at, sensor.who, inner.parent, inner.siblings)


def _finding(child: Element, who: str, parent: str, known: Iterable[str]) -> Finding:
    message = f"{who}: unknown element <{child.tag}> in <{parent}> (ignored)"
    if instead := _INSTEAD.get(child.tag):
        return Finding(child, message, instead, alike=child.tag)
    hint = did_you_mean(child.tag, known)
    return Finding(child, message + hint, fix=_fix(child, known), alike=child.tag)


def _fix(child: Element, known: Iterable[str]) -> Fix | None:
    suggested = nearest(child.tag, known, _TYPO)
    edits = rename_element(child, suggested) if suggested else None
    return Fix.of(f"rename it to <{suggested}>", edits)

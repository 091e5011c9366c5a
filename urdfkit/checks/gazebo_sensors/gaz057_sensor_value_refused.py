"""A setting of a sensor has a value that Gazebo refuses.

Text where a number belongs, a pose of three numbers, a word that SDF does not know, an image of no
pixels or a noise with a negative deviation: gz-sim rejects the model with a line in its log, and
Gazebo Classic takes a default or makes no sensor. Angles in degrees and inverted ranges have rules
of their own. A number ends where its characters end: `50 cm` is 50 m to Gazebo, and an image `1e3`
pixels wide has one; that 666.5 beams are taken for 666 is not reported.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    sdformat, Camera.cc: https://github.com/gazebosim/sdformat/blob/main/src/Camera.cc
    sdformat, Param.cc: https://github.com/gazebosim/sdformat/blob/main/src/Param.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from math import isnan

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.robot.model import number
from urdfkit.ros.catalog.sensors import Setting
from urdfkit.ros.gazebo.sensors import Sensor, sensors, written
from urdfkit.ros.gazebo.values import leading, value
from urdfkit.text.diagnostic import Severity
from urdfkit.text.document import Attribute, Element

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="camera" type="camera">
    <camera>
      <image><width>640</width><height>480</height><format>RGB888</format></image>
    </camera>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("RGB888", "R8G8B8")

_NUMBERS = ("float", "int", "uint")
#: Settings of which 0 and less make nothing.
_POSITIVE = ("width", "height", "samples")
#: Of the bounds of these GAZ048 and GAZ047 tell.
_BOUNDED_ELSEWHERE = ("horizontal_fov", "near", "far")
_LENGTHS = {"vector2": 2, "vector3": 3, "pose": 6}
_BOOLEANS = ("true", "false", "1", "0")
#: Children of every sensor.
_COMMON = {
    "update_rate": Setting("float"),
    "always_on": Setting("bool"),
    "visualize": Setting("bool"),
    "enable_metrics": Setting("bool"),
    "pose": Setting("pose"),
}


@rule(Severity.ERROR, help="write what SDF reads there")
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        for at, name, text, setting in _values(sensor):
            if wrong := _wrong(name, setting, text):
                shown = f"'{text}'" if text else "empty"
                called = f"attribute {name}" if isinstance(at, Attribute) else f"<{name}>"
                yield Finding(at, f"{sensor.who}: {called} is {shown}, and {wrong}")


def _values(sensor: Sensor) -> Iterator[tuple[Element | Attribute, str, str, Setting]]:
    """Where a value stands, its name, itself, and what SDF knows of it."""
    for child in sensor.at.children:
        if setting := _COMMON.get(child.tag):
            yield child, child.tag, child.text.strip(), setting
    for inner in written(sensor):
        if inner.setting is not None:
            yield inner.at, inner.at.tag, inner.at.text.strip(), inner.setting
        for attribute, setting in inner.attributes():
            yield attribute, attribute.name, attribute.value.strip(), setting


def _wrong(name: str, setting: Setting, text: str) -> str:
    """What a value must be and is not; empty if it is right."""
    if setting.words and text not in setting.words:
        few = ", ".join(setting.words) if len(setting.words) < 8 else "one of SDF's words"
        return f"must be {few}{did_you_mean(text, setting.words)}"
    if setting.type in _NUMBERS:
        return _wrong_number(name, setting, text)
    if setting.type == "bool" and text.lower() not in _BOOLEANS:
        return "must be true or false"
    length = _LENGTHS.get(setting.type)
    parts = [number(part) for part in text.split()]
    if length and (len(parts) != length or None in parts):
        return f"must be {length} numbers with spaces between them"
    return ""


def _wrong_number(name: str, setting: Setting, text: str) -> str:
    read, rest = leading(text, whole=setting.type != "float")
    if not read or rest.startswith(",") or isnan(found := value(read)):
        return "must be a number"
    if rest and not (setting.type != "float" and rest[0] == "." and rest[1:].isdecimal()):
        return f"Gazebo reads {read} and ignores '{rest}'"
    if name in _BOUNDED_ELSEWHERE:
        return ""
    if name in _POSITIVE and found < 1:
        return "must be 1 or more"
    least, greatest = setting.least, setting.greatest
    if least is None and setting.type == "uint":
        least = 0.0
    if least is not None and found < least:
        return f"must be {least:g} or more"
    if greatest is not None and found > greatest:
        return f"must be {greatest:g} or less"
    return ""

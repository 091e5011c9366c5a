"""A setting of a sensor has a value that Gazebo refuses.

Text where a number belongs, a pose of three numbers, a word that SDF does not know, an image of no
pixels or a noise with a negative deviation: gz-sim rejects the model with a line in its log, and
Gazebo Classic takes a default or makes no sensor. Angles in degrees and inverted ranges have rules
of their own.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    sdformat, Camera.cc: https://github.com/gazebosim/sdformat/blob/main/src/Camera.cc
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.catalog.sensors import Setting
from urdfkit.diagnostic import Severity
from urdfkit.gazebo.sensors import Sensor, sensors, written
from urdfkit.model import number
from urdfkit.nearest import did_you_mean
from urdfkit.rules import Finding, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.document import Element
    from urdfkit.subject import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="eye" type="camera">
    <camera>
      <image><width>640</width><height>480</height><format>RGB888</format></image>
    </camera>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("RGB888", "R8G8B8")

#: Gazebo reads a number and passes over what follows it, such as a unit.
_NUMBER = r"\s*[-+]?(\d+\.?\d*|\.\d+)(e[-+]?\d+)?"
_NUMBERS = ("float", "int", "uint")
#: Settings of which 0 and less make nothing.
_POSITIVE = ("width", "height", "samples")
#: Of these GAZ048 and GAZ056 tell.
_ELSEWHERE = ("horizontal_fov", "near", "far")
_LENGTHS = {"vector2": 2, "vector3": 3, "pose": 6}
_BOOLEANS = ("true", "false", "1", "0")
#: Children of every sensor.
_COMMON = {
    "update_rate": Setting("float"),
    "always_on": Setting("bool"),
    "visualize": Setting("bool"),
    "pose": Setting("pose"),
}


@rule("GAZ057", "sensor-value-refused", Severity.ERROR, help="write what SDF reads there")
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        for at, setting in _settings(sensor):
            text = at.text.strip()
            if wanted := _wanted(at.tag, setting, text):
                shown = f"'{text}'" if text else "empty"
                yield Finding(at, f"{sensor.who}: <{at.tag}> is {shown}, and must be {wanted}")


def _settings(sensor: Sensor) -> Iterator[tuple[Element, Setting]]:
    for child in sensor.at.children:
        if setting := _COMMON.get(child.tag):
            yield child, setting
    for inner in written(sensor):
        if inner.setting is not None:
            yield inner.at, inner.setting


def _wanted(tag: str, setting: Setting, text: str) -> str:
    """What a value must be and is not; empty if it is right."""
    if setting.words and text not in setting.words:
        few = ", ".join(setting.words) if len(setting.words) < 8 else "one of SDF's words"
        return few + did_you_mean(text, setting.words)
    if setting.type in _NUMBERS:
        return "" if tag in _ELSEWHERE else _wanted_number(tag, setting, text)
    if setting.type == "bool" and text.lower() not in _BOOLEANS:
        return "true or false"
    length = _LENGTHS.get(setting.type)
    parts = [number(part) for part in text.split()]
    if length and (len(parts) != length or None in parts):
        return f"{length} numbers with blanks between them"
    return ""


def _wanted_number(tag: str, setting: Setting, text: str) -> str:
    found = re.match(_NUMBER, text, re.IGNORECASE)
    if found is None or text[found.end() :].startswith(","):
        return "a number"
    value = float(found.group())
    if tag in _POSITIVE and value < 1:
        return "1 or more"
    least, greatest = setting.least, setting.greatest
    if least is None and setting.type == "uint":
        least = 0.0
    if least is not None and value < least:
        return f"{least:g} or more"
    if greatest is not None and value > greatest:
        return f"{greatest:g} or less"
    return ""

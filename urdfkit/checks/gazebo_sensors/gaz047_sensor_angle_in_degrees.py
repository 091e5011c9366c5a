"""An angle of a sensor is in degrees.

SDF expects radians. A lidar of 180 degrees then spans 180 radians, 28 full turns, and a sensor that
is rotated by 90 in its `<pose>` looks 117 degrees to the side. For the `<horizontal_fov>` of a
camera it is an error: Gazebo rejects the model ("horizontal fov must be greater than zero and less
than or equal to two pi").

Sources:
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    SDF, camera.sdf: https://github.com/gazebosim/sdformat/blob/main/sdf/1.9/camera.sdf
"""

from math import pi, radians

from urdfkit.core.words import spaced
from urdfkit.lint.rules import Confidence, Context, Finding, Findings, Severity, rule
from urdfkit.robot.values import number, numbers
from urdfkit.ros.gazebo import REJECTED
from urdfkit.ros.gazebo.samples import LIDAR
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import fix_value

BAD = LIDAR.replace(">-1<", ">-90<").replace(">1<", ">90<")
GOOD = FIXED = BAD.replace("90<", "1.5708<")

_ANGLES = [
    f"scan/{way}/{end}_angle" for way in ("horizontal", "vertical") for end in ("min", "max")
]


@rule(Severity.WARNING, help="write the angle in radians")
def check(context: Context) -> Findings:
    for sensor in sensors(context.model):
        for path in _ANGLES:
            angle = sensor.number(f"{sensor.lidar}/{path}") if sensor.lidar else None
            if angle is not None:
                who = f"{sensor.who}: <{path.rpartition('/')[2]}> is"
                yield from _over_a_turn(angle.at, who, angle.value, f"{radians(angle.value):.6g}")
        yield from _turned_far(sensor)
        yield from _field_of_view(sensor)


def _turned_far(sensor: Sensor) -> Findings:
    """A sensor whose pose rotates it by more than a full turn."""
    for pose in sensor.at.all("pose"):
        values = numbers(pose.text)
        if not values or len(values) != 6 or (pose.get("degrees") or "").lower() in ("true", "1"):
            continue
        who, most = f"{sensor.who}: <pose> rotates it by", max(values[3:], key=abs)
        right = spaced((*values[:3], *map(radians, values[3:])))
        yield from _over_a_turn(pose, who, most, right)


def _over_a_turn(at: Element | Attribute, who: str, angle: float, right: str) -> Findings:
    if abs(angle) > 2 * pi + 1e-3:
        message = f"{who} {angle:g} rad, more than a full turn"
        help, fix = f"if it is in degrees, write {right}", fix_value(at, right)
        yield Finding(at, message, help, fix, confidence=Confidence.INFERRED)


def _field_of_view(sensor: Sensor) -> Findings:
    for camera in sensor.at.all("camera"):
        element = camera.child("horizontal_fov")
        value = number(element.text.strip()) if element else None
        if element is None or value is None or 0 < value <= 2 * pi:
            continue
        text = f"{radians(value):.6g}"
        yield Finding(
            element,
            f"{sensor.who}: <horizontal_fov> is {value:g} rad, must be in (0, 2 pi]: {REJECTED}",
            f"if it is in degrees, write {text}" if value > 0 else "",
            fix_value(element, text) if value > 0 else None,
            severity=Severity.ERROR,
        )

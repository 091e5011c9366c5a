"""A lidar's least range or angle is not below its greatest.

No beam can ever hit anything: the lidar is blind, and navigation sees an empty world. Both ranges
are 0 if they are not written. gz-sim rejects a model whose beams begin at a larger angle than they
end; the rays of Gazebo Classic sweep backwards then.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gz-sensors, Lidar.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Lidar.cc
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.gazebo.samples import LIDAR
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.targets import CLASSIC, GZ
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import swap

BAD = LIDAR.replace("<min>0.1</min><max>10</max>", "<min>10</min><max>0.1</max>")
GOOD = FIXED = LIDAR


@rule(Severity.ERROR, help="let the least be below the greatest")
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        block = sensor.at.child(sensor.lidar) if sensor.lidar else None
        if block is None:
            continue
        if sensor.find(f"{block.tag}/range") is None:
            message = f"{sensor.who} has no <range>: the least and the greatest are both 0 m"
            yield Finding(block, message, "add <range> with <min> and <max>")
        yield from _inverted(sensor, "range", "range/min", "range/max", "m")
        least = sensor.number(f"{block.tag}/range/min")
        if least and least.value < 0:
            message = f"{sensor.who}: the least range is {least.value:g} m, and no beam is so short"
            yield Finding(least, message, "write 0 or more")
        if _may_sweep_backwards(sensor, subject):
            continue
        for way in ("horizontal", "vertical"):
            first, last = (f"scan/{way}/{end}_angle" for end in ("min", "max"))
            samples = sensor.number(f"{block.tag}/scan/{way}/samples")
            if samples and samples.value > 1:
                yield from _inverted(sensor, f"{way} angle", first, last, "rad")


def _may_sweep_backwards(sensor: Sensor, subject: Subject) -> bool:
    """True for the rays of Gazebo Classic, which go from the first angle to the last."""
    targets = subject.targets
    return sensor.type == "ray" and targets.any_of(CLASSIC) and not targets.any_of(GZ)


def _inverted(sensor: Sensor, what: str, first: str, last: str, unit: str) -> Findings:
    least, greatest = (sensor.number(f"{sensor.lidar}/{path}") for path in (first, last))
    if least is None or greatest is None or least.value < greatest.value:
        return
    message = f"{sensor.who}: the least {what} {least.value:g} {unit} is not below the greatest"
    edits = swap(least.at, greatest.at)
    fix = Fix("swap the two", edits) if edits and least.value > greatest.value else None
    yield Finding(least, f"{message}, {greatest.value:g} {unit}", fix=fix)

"""The first and last beam of a lidar have the same direction, or its beams exceed a full circle.

The angles span a full circle, and both ends are sampled: the same direction is measured twice, and
scan matching has a seam. With more than a circle, many directions are measured twice. Omit one
step: with n samples the last angle is 2 pi (1 - 1/n) after the first.

Sources:
    SteveMacenski/slam_toolbox#293: https://github.com/SteveMacenski/slam_toolbox/issues/293
    gazebosim/gz-sim#2743: https://github.com/gazebosim/gz-sim/issues/2743
"""

from math import pi

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.ros.gazebo.samples import LIDAR
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.editing.edits import fix_value

BAD = LIDAR.replace(">-1<", ">-3.1415926<").replace(">1<", ">3.1415926<")
GOOD = BAD.replace(">3.1415926<", ">3.1241<")
FIXED = BAD.replace(">3.1415926<", ">3.12414<")


@rule(Severity.INFO, help="end one step before the full circle")
def check(context: Context) -> Findings:
    for sensor in sensors(context.model):
        scan = f"{sensor.lidar}/scan/horizontal"
        first, last = sensor.number(f"{scan}/min_angle"), sensor.number(f"{scan}/max_angle")
        samples = sensor.number(f"{scan}/samples")
        if not sensor.lidar or first is None or last is None or samples is None:
            continue
        span, count = last.value - first.value, samples.value
        if count <= 1 or max(abs(first.value), abs(last.value)) > 2 * pi + 1e-3:  # GAZ047
            continue
        step = 2 * pi / count
        if span > 2 * pi - step / 2:
            text = f"{first.value + 2 * pi - step:.6g}"
            more = "the first and the last coincide"
            if span > 2 * pi + step / 2:
                more = "the last repeat the first"
            message = f"{sensor.who}: {count:g} beams over {span:g} rad: {more}"
            yield Finding(last, message, f"write {text}", fix_value(last.at, text))

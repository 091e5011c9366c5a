"""A sensor's update rate is negative, or a camera's or lidar's is zero or not written.

Zero, which is also what is taken where none is written, means every step of the simulation, a
thousand times a second: for a camera or a lidar that brings the simulation to a crawl. A negative
rate has no meaning.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gz-sensors, Sensor.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Sensor.cc
    ros-simulation/gazebo_ros_pkgs#366: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/366
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, rule
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Severity

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="camera" type="camera">
    <update_rate>0</update_rate>
  </sensor>
</gazebo>"""
GOOD = BAD.replace(">0<", ">30<")

#: In the types of sensors that are rendered, or cast rays.
_HEAVY = ("camera", "depth", "lidar", "ray")


@rule(Severity.WARNING, help="give the rate of the real sensor in Hz")
def check(subject: Subject) -> Findings:
    for sensor in sensors(subject.model):
        is_heavy = bool(sensor.lidar) or any(word in sensor.type for word in _HEAVY)
        if is_heavy and sensor.find("update_rate") is None:
            message = (
                f"{sensor.who} has no <update_rate>, and works at every step of the simulation"
            )
            yield Finding(sensor.at, message, "add <update_rate> with the rate of the real sensor")
        rate = sensor.number("update_rate")
        if rate is None:
            continue
        if rate.value < 0 or (rate.value == 0 and is_heavy):
            meaning = "has no meaning" if rate.value < 0 else "means every step of the simulation"
            yield Finding(rate, f"{sensor.who}: an update rate of {rate.value:g} Hz {meaning}")

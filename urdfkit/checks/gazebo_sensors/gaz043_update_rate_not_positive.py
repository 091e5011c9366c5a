"""The update rate of a sensor is negative, or that of a camera or lidar is zero or missing.

Zero, the default, means every step of the simulation, a thousand times a second: a camera or a
lidar then slows the simulation down to a fraction of real time. A negative rate is invalid.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    gz-sensors, Sensor.cc: https://github.com/gazebosim/gz-sensors/blob/main/src/Sensor.cc
    ros-simulation/gazebo_ros_pkgs#366: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/366
"""

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.ros.gazebo.sensors import sensors

BAD = robot_xml(
    solid_xml("base"),
    gazebo_xml(sensor_xml("camera", "camera", "<update_rate>0</update_rate>"), reference="base"),
)
GOOD = BAD.replace(">0<", ">30<")

#: Parts of the types of sensors that are rendered, or cast rays.
_HEAVY = ("camera", "depth", "lidar", "ray")


@rule(Severity.WARNING, help="give the rate of the real sensor in Hz")
def check(context: Context) -> Findings:
    for sensor in sensors(context.model):
        is_heavy = bool(sensor.lidar) or any(word in sensor.type for word in _HEAVY)
        if is_heavy and sensor.find("update_rate") is None:
            message = (
                f"{sensor.who} has no <update_rate> and updates in every step of the simulation"
            )
            yield Finding(sensor.at, message, "add <update_rate> with the rate of the real sensor")
        rate = sensor.number("update_rate")
        if rate is None:
            continue
        if rate.value < 0 or (rate.value == 0 and is_heavy):
            why = "must be > 0" if rate.value < 0 else "which means every step of the simulation"
            yield Finding(rate, f"{sensor.who}: update rate is {rate.value:g} Hz, {why}")

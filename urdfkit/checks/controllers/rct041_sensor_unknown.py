"""A broadcaster publishes a sensor that the robot's `<ros2_control>` does not have.

`sensor_name` is the name of a `<sensor>` in a block; the interfaces of the broadcaster begin with
it. The controller manager finds none of them, and the broadcaster cannot be activated, unless the
driver of the hardware brings sensors along that the description does not name.

Sources:
    imu_sensor_broadcaster.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/imu_sensor_broadcaster/src/imu_sensor_broadcaster.cpp
    force_torque_sensor_broadcaster.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/force_torque_sensor_broadcaster/src/force_torque_sensor_broadcaster.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.ros.controllers import controllers
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Confidence, Severity
from urdfkit.text.grammar import is_expression

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = (
    ARM
    + """\
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
  <sensor name="imu">
    <state_interface name="orientation.x"/>
  </sensor>
</ros2_control>
"""
    + CONTROL
)
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    imu_broadcaster:
      type: imu_sensor_broadcaster/IMUSensorBroadcaster
imu_broadcaster:
  ros__parameters:
    sensor_name: imu
    frame_id: base
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"sensor_name: imu", b"sensor_name: imu_sensor"),
    "config/good.yaml": _YAML,
}

_BROADCASTERS = (
    "imu_sensor_broadcaster/IMUSensorBroadcaster",
    "force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster",
    "range_sensor_broadcaster/RangeSensorBroadcaster",
    "gps_sensor_broadcaster/GPSSensorBroadcaster",
)


@rule("RCT041", "sensor-unknown", Severity.WARNING, help="name a <sensor> of the <ros2_control>")
def check(subject: Subject) -> Iterator[Finding]:
    parts = [part for component in components(subject.model) for part in component.parts]
    sensors = {part.name for part in parts if part.kind == "sensor"}
    if not sensors:
        return  # the file may be that of another robot, too, and nobody start the broadcaster
    for file, found in controllers(subject):
        for controller in found:
            if controller.type not in _BROADCASTERS:
                continue
            for value in controller.values(["sensor_name"]):
                name = value.text
                if name and not is_expression(name) and all(part.name != name for part in parts):
                    yield Finding(
                        Location(value.span),
                        f"controller '{controller.name}' publishes the sensor '{name}', which no "
                        f"<ros2_control> has{did_you_mean(name, sensors)}",
                        related=(file.note,),
                        confidence=Confidence.INFERRED,
                    )

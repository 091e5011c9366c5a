"""A sensor of ros2_control has no counterpart in Gazebo.

The hardware of a simulator finds its sensors by their names: a `<sensor>` in `<ros2_control>` that
is called otherwise than the `<sensor>` in `<gazebo>` exports nothing, and the broadcaster that
waits for it does not start.

Sources:
    gazebo_ros2_control, gazebo_system.cpp: https://github.com/ros-controls/gazebo_ros2_control/blob/master/gazebo_ros2_control/src/gazebo_system.cpp
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import Suggester
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.ros_control import hardware
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="base">
  <sensor name="base_imu" type="imu">
    <update_rate>100</update_rate>
  </sensor>
</gazebo>
<ros2_control name="robot" type="system">
  <hardware>
    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
  </hardware>
  <sensor name="base_immu">
    <state_interface name="orientation.x"/>
  </sensor>
</ros2_control>"""
FIXED = GOOD = BAD.replace("base_immu", "base_imu")


@rule(
    "RCT032",
    "sensor-not-simulated",
    Severity.WARNING,
    help="give both sensors the same name",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    if subject.is_part:
        return
    simulated = {sensor.name for sensor in sensors(subject.model)}
    suggester = Suggester(simulated)
    for component in components(subject.model):
        if component.hardware not in hardware():
            continue
        for part in component.parts:
            name = part.at.attributes.get("name")
            if part.kind != "sensor" or name is None or name.value in simulated:
                continue
            suggested, hint = suggester.suggested(name.value), suggester.hint(name.value)
            edits = replace_value(name, suggested) if suggested else None
            yield Finding(
                name,
                f"sensor '{name.value}' of ros2_control: no <sensor> of <gazebo> has that name"
                + hint,
                fix=Fix.of(f"rename it to '{suggested}'", edits),
            )

"""A plugin is to publish faster than its sensor measures.

The plugin's rate only leaves measurements out; it cannot make more of them. The sensor's
`<update_rate>` is what counts. A plugin's rate of 0 means every measurement.

Sources:
    ros-simulation/gazebo_ros_pkgs#366: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/366
    tu-darmstadt-ros-pkg/hector_gazebo#94: https://github.com/tu-darmstadt-ros-pkg/hector_gazebo/issues/94
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.model import number
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<gazebo reference="base">
  <sensor name="camera" type="camera">
    <update_rate>10</update_rate>
    <plugin name="driver" filename="libcamera_of_ours.so"><updateRate>30</updateRate></plugin>
  </sensor>
</gazebo>"""
GOOD = BAD.replace(">30<", ">5<")

_TAGS = ("updateRate", "update_rate")


@rule(
    "GAZ044",
    "conflicting-rates",
    Severity.INFO,
    help="raise the sensor's rate, or leave out the plugin's",
)
def check(subject: Subject) -> Iterator[Finding]:
    for sensor in sensors(subject.model):
        measured = sensor.number("update_rate")
        for plugin in sensor.plugins:
            for tag in _TAGS:
                element = plugin.child(tag)
                rate = number(element.text.strip()) if element else None
                if element and rate and measured and rate > measured.value > 0:
                    rates = f"measures at {measured.value:g} Hz, and its plugin sends {rate:g} Hz"
                    yield Finding(element, f"{sensor.who} {rates}")

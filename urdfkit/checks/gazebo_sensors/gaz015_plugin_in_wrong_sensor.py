"""A plugin is in a sensor of a type that it does not serve.

A plugin asks its sensor for the data of one type, and gives up, or ends the server, where it is of
another: a laser plugin needs a `ray` sensor, a GPU laser `gpu_ray`, a depth camera `depth`.

Sources:
    Gazebo Classic, plugins: https://classic.gazebosim.org/tutorials?tut=ros_gzplugins
    gazebo_ros_laser.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_laser.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="laser">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo reference="laser">
  <sensor name="scan" type="gpu_ray">
    <plugin name="laser" filename="libgazebo_ros_laser.so"/>
  </sensor>
</gazebo>"""
GOOD = BAD.replace("gpu_ray", "ray")

#: What SDF calls the same, and the sensors that are cameras, too.
_SAME = {
    "lidar": "ray",
    "gpu_lidar": "gpu_ray",
    "depth_camera": "depth",
    "navsat": "gps",
    "wideanglecamera": "wide_angle_camera",
}
_CAMERAS = ("depth", "wide_angle_camera")


@rule("GAZ015", "plugin-in-wrong-sensor", Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        if use.place != "sensor" or use.plugin is None or not use.plugin.sensors:
            continue
        assert use.at.parent is not None
        attribute = use.at.parent.attributes.get("type")
        if attribute is None:
            continue
        serves = {_SAME.get(kind, kind) for kind in use.plugin.sensors}
        kind = _SAME.get(attribute.value, attribute.value)
        if kind in serves or (kind in _CAMERAS and "camera" in serves):
            continue
        wanted = " or ".join(f"'{one}'" for one in use.plugin.sensors)
        message = f"{use.title} serves a sensor of type {wanted}, and this is '{attribute.value}'"
        yield Finding(attribute, message, f"make the sensor {wanted}, or take another plugin")

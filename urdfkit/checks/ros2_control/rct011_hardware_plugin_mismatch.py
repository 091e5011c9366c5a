"""The hardware plugin belongs to another simulator than the control plugin that is to load it.

Each control plugin loads only its own kind of hardware. Another one is logged and passed over: the
controller manager then has no interfaces, and no controller can be activated. Gazebo Classic's
plugin goes with `gazebo_ros2_control/GazeboSystem`, gz_ros2_control with
`gz_ros2_control/GazeboSimSystem`.

Sources:
    gz_ros2_control: https://github.com/ros-controls/gz_ros2_control/blob/rolling/doc/index.rst
    gazebo_ros2_control: https://github.com/ros-controls/gazebo_ros2_control/blob/master/doc/index.rst
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.ros_control import hardware
from urdfkit.ros.ros_control import components, control_plugins
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="arm">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="10" velocity="1"/>
</joint>
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>gazebo_ros2_control/GazeboSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="position"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>
<gazebo>
  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
    <parameters>/home/student/arm_description/config/controllers.yaml</parameters>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("gazebo_ros2_control/GazeboSystem", "gz_ros2_control/GazeboSimSystem")
FILES = {
    "config/controllers.yaml": b"controller_manager:\n  ros__parameters:\n    update_rate: 9\n"
}


@rule(
    "RCT011",
    "hardware-plugin-mismatch",
    Severity.ERROR,
    help="take the hardware plugin and the control plugin of the same simulator",
)
def check(subject: Subject) -> Iterator[Finding]:
    plugins = control_plugins(subject.model)
    kinds = {plugin.kind for plugin in plugins}
    if not plugins:
        return  # RCT010
    for component in components(subject.model):
        found = hardware().get(component.hardware)
        if found and found.control not in kinds and component.plugin:
            suitable = [h.name for h in hardware().values() if h.control in kinds]
            yield Finding(
                component.plugin,
                f"{component.called}: hardware plugin {found.name} is not one that "
                f"{plugins[0].filename} loads"
                + (f" ({' or '.join(suitable)})" if suitable else ""),
                related=(Related(plugins[0].at.span, "the control plugin"),),
            )

"""A controller needs a command interface that the robot's `<ros2_control>` does not offer.

The controller manager finds no such interface and the controller cannot be activated: "not in the
list of available interfaces". Add the command interface to the joint, if the hardware has it, or
take a controller for the interface that is there. Joints without any block are another rule's.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.catalog.ros_control import controllers as catalogue
from urdfkit.controllers import Controller, controllers
from urdfkit.diagnostic import Related, Severity
from urdfkit.placed_yaml import Value
from urdfkit.ros_control import components
from urdfkit.rules import Finding, Written, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

_WHEEL = """\
<link name="{side}_wheel">
  <collision>
    <origin rpy="1.5707963 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry>
  </collision>
  <inertial>
    <mass value="0.2"/>
    <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/>
  </inertial>
</link>
<joint name="{side}_joint" type="continuous">
  <parent link="base"/>
  <child link="{side}_wheel"/>
  <origin xyz="0 {y} 0"/>
  <axis xyz="0 1 0"/>
</joint>
"""
BAD = f"""\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
{_WHEEL.format(side="left", y=0.15)}{_WHEEL.format(side="right", y=-0.15)}\
<ros2_control name="base" type="system">
  <hardware>
    <plugin>gz_ros2_control/GazeboSimSystem</plugin>
  </hardware>
  <joint name="left_joint">
    <command_interface name="velocity"/>
    <state_interface name="position"/>
  </joint>
  <joint name="right_joint">
    <command_interface name="velocity"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>
<gazebo>
  <plugin name="gz_ros2_control::GazeboSimROS2ControlPlugin" filename="gz_ros2_control-system">
    <parameters>/home/student/arm_description/config/bad.yaml</parameters>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    drive:
      type: diff_drive_controller/DiffDriveController
drive:
  ros__parameters:
    left_wheel_names: [left_joint]
    right_wheel_names: [right_joint]
    wheel_separation: 0.3
    wheel_radius: 0.1
"""
_OTHER = _YAML.replace(b"diff_drive_controller/DiffDrive", b"effort_controllers/JointGroupEffort")
FILES = {
    "config/bad.yaml": _OTHER.replace(b"left_wheel_names", b"joints"),
    "config/good.yaml": _YAML,
}


@rule(
    "RCT021",
    "interface-not-offered",
    Severity.ERROR,
    help="add the <command_interface> to the joint, or take another controller",
)
def check(subject: Subject) -> Iterator[Finding]:
    offered = {
        # gazebo_ros2_control offers position_pid as position, with a PID of its own behind it.
        part.name: {interface.name.removesuffix("_pid") for interface in part.of("command")}
        for component in components(subject.model)
        for part in component.joints
    }
    for file, found in controllers(subject):
        for controller in found:
            wanted = _wanted(controller)
            for value in _joints(controller):
                has = offered.get(value.text)
                missing = [name for name in wanted if has is not None and name not in has]
                if missing and has is not None:
                    there = ", ".join(sorted(has)) or "none"
                    yield Finding(
                        Written(value.span),
                        f"controller '{controller.name}' commands the {' and the '.join(missing)} "
                        f"of joint '{value.text}', whose command interfaces are: {there}",
                        related=(Related(file.span, "the file is named here"),),
                    )


def _wanted(controller: Controller) -> list[str]:
    """The command interfaces that it needs of each joint; empty if that is not known."""
    kind = catalogue().get(controller.type)
    if kind is None:
        return []
    if kind.interface:
        return [kind.interface]
    named = controller.values([kind.interfaces]) if kind.interfaces else []
    return [value.text for value in named if value.text]


def _joints(controller: Controller) -> list[Value]:
    """The joints that it commands; ``command_joints`` wins over ``joints``."""
    kind = catalogue().get(controller.type)
    commanded = controller.values(["command_joints"])
    return commanded or (controller.values(kind.joints) if kind else [])

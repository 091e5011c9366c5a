"""A controller needs a command interface that the robot's joints do not offer.

The controller manager finds no such interface and the controller cannot be activated: "not in the
list of available interfaces". Add the command interface to the joint, if the hardware has it, or
take a controller for the interface that is there. Joints without any block are another rule's. In
ROS 1 it is the `<hardwareInterface>` of the joint's transmission that Gazebo goes by.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.ros.catalog.ros_control import controllers as catalogue
from urdfkit.ros.controllers import Controller, controllers
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.ros.ros_control import components, control_plugins, driven_joints
from urdfkit.text.diagnostic import Severity
from urdfkit.text.located_yaml import Value

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
    <command_interface name="velocity"/>
    <state_interface name="velocity"/>
  </joint>
</ros2_control>
"""
    + CONTROL
)
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    drive:
      type: velocity_controllers/JointGroupVelocityController
drive:
  ros__parameters:
    joints: [shoulder]
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"velocity", b"effort").replace(b"Velocity", b"Effort"),
    "config/good.yaml": _YAML,
}

#: The control plugin of ROS 1, the interfaces of its joints, and those that controllers need.
_OF_ROS1 = "gazebo_ros_control"
_INTERFACES = {
    "PositionJointInterface": "position",
    "VelocityJointInterface": "velocity",
    "EffortJointInterface": "effort",
}
_BY_PACKAGE = {f"{kind}_controllers": kind for kind in _INTERFACES.values()}


@rule(
    "RCT021",
    "interface-not-offered",
    Severity.ERROR,
    help="give the joint this interface, or take another controller",
)
def check(subject: Subject) -> Iterator[Finding]:
    read = list(controllers(subject))
    by_ros = {1: _transmitted(subject), 2: _offered(subject)}
    served = {
        value.text
        for _, found in read
        for one in found
        for value in _joints(one)
        if one.ros == 1 and by_ros[1].get(value.text, set()).issuperset(_wanted(one))
    }
    for name in served:  # another controller of the file is for this joint as it is
        by_ros[1].pop(name, None)
    for file, found in read:
        for controller in found:
            wanted, offered = _wanted(controller), by_ros[controller.ros]
            for value in _joints(controller):
                has = offered.get(value.text)
                missing = [name for name in wanted if has is not None and name not in has]
                if missing and has is not None:
                    there = ", ".join(sorted(has)) or "none"
                    yield Finding(
                        Location(value.span),
                        f"controller '{controller.name}' commands the {' and the '.join(missing)} "
                        f"of joint '{value.text}', whose command interfaces are: {there}",
                        related=(file.note,),
                    )


def _offered(subject: Subject) -> dict[str, set[str]]:
    """The command interfaces of the joints in ``<ros2_control>``."""
    return {
        # gazebo_ros2_control offers position_pid as position, with a PID of its own behind it.
        part.name: {interface.name.removesuffix("_pid") for interface in part.of("command")}
        for component in components(subject.model)
        for part in component.joints
    }


def _transmitted(subject: Subject) -> dict[str, set[str]]:
    """What Gazebo offers of joints in ROS 1; real hardware may offer more.

    Files of ROS 1 often hold controllers for each interface, of which a launch file starts some.
    """
    if not any(plugin.kind == _OF_ROS1 for plugin in control_plugins(subject.model)):
        return {}
    offered: dict[str, set[str]] = {}
    for joint, _ in driven_joints(subject.model):
        for interface in joint.all("hardwareInterface"):
            name = interface.text.strip().removeprefix("hardware_interface/")
            if name in _INTERFACES:
                offered.setdefault(joint.get("name") or "", set()).add(_INTERFACES[name])
    return offered


def _wanted(controller: Controller) -> list[str]:
    """The command interfaces that it needs of each joint; empty if that is not known."""
    if controller.ros == 1 and (wanted := _BY_PACKAGE.get(controller.type.partition("/")[0])):
        return [wanted]
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

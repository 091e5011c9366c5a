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
from urdfkit.diagnostic import Severity
from urdfkit.gazebo.samples import ARM, CONTROL
from urdfkit.placed_yaml import Value
from urdfkit.ros_control import components
from urdfkit.rules import Finding, Written, rule
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.subject import Subject

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
                        related=(file.note,),
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

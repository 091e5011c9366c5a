"""A controller needs a state interface that the robot's `<ros2_control>` does not offer.

The controller manager finds no such interface, and the controller cannot be activated. Add the
state interface to the joint, if the hardware measures it, or let the controller do without:
`position_feedback: false` or `open_loop: true` of a wheel controller, `state_interfaces` of one for
trajectories. Joints without any block are another rule's.

Sources:
    diff_drive_controller.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/diff_drive_controller/src/diff_drive_controller.cpp
    joint_trajectory_controller.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/joint_trajectory_controller/src/joint_trajectory_controller.cpp
    gripper_action_controller_impl.hpp: https://github.com/ros-controls/ros2_controllers/blob/humble/gripper_controllers/include/gripper_controllers/gripper_action_controller_impl.hpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.ros.catalog.ros_control import controllers as catalogue
from urdfkit.ros.controllers import Controller, controllers
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Severity

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
</ros2_control>
"""
    + CONTROL
)
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
arm:
  ros__parameters:
    joints: [shoulder]
    command_interfaces: [position]
    state_interfaces: [position]
"""
FILES = {
    "config/bad.yaml": _YAML.replace(
        b"state_interfaces: [position]", b"state_interfaces: [velocity]"
    ),
    "config/good.yaml": _YAML,
}

_GRIPPER = "GripperActionController"
_DRIVE = "diff_drive_controller/DiffDriveController"


@rule("RCT040", "state-not-offered", Severity.ERROR, help="add the <state_interface> to the joint")
def check(subject: Subject) -> Iterator[Finding]:
    offered = {
        part.name: {interface.name for interface in part.of("state")}
        for component in components(subject.model)
        for part in component.joints
    }
    for file, found in controllers(subject):
        for controller in found:
            kind = catalogue().get(controller.type)
            names = [name for name in kind.joints if name != "command_joints"] if kind else []
            wanted = _wanted(controller)
            for value in controller.values(names):
                has = offered.get(value.text)
                missing = [name for name in wanted if has is not None and name not in has]
                if missing and has is not None:
                    yield Finding(
                        Location(value.span),
                        f"controller '{controller.name}' needs the {' and the '.join(missing)} of "
                        f"joint '{value.text}', whose state interfaces are: "
                        + (", ".join(sorted(has)) or "none"),
                        related=(file.note,),
                    )


def _wanted(controller: Controller) -> list[str]:
    """The state interfaces that it needs of each joint; empty if that is not known."""
    if controller.type == _DRIVE:
        if _is(controller, "open_loop", "true"):
            return []
        return ["velocity" if _is(controller, "position_feedback", "false") else "position"]
    if controller.type.endswith(_GRIPPER):
        return ["position", "velocity"]
    return [value.text for value in controller.values(["state_interfaces"]) if value.text]


def _is(controller: Controller, name: str, word: str) -> bool:
    return any(value.text.lower() == word for value in controller.values([name]))

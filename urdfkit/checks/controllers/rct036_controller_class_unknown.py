"""The type of a controller is a class that its package does not have in this version of ROS.

The controller manager does not load it: "Loader for controller 'x' (type 'y') not found". Many
types of ROS 1 live on in ROS 2 under another name. Only packages that urdfkit knows are reported.

Sources:
    ros2_controllers: https://control.ros.org/master/doc/ros2_controllers/doc/controllers_index.html
    ros_controllers: https://wiki.ros.org/ros_controllers
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.ros.catalog.controllers import classes, successor
from urdfkit.ros.controllers import Controller, controllers
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = ARM + CONTROL
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
    "config/bad.yaml": _YAML.replace(b"joint_trajectory_controller/", b"position_controllers/"),
    "config/good.yaml": _YAML,
}

#: Types that are more like another one are misspelt, which is RCT027.
_TYPO = 0.93


@rule("RCT036", "controller-class-unknown", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    for file, found in controllers(subject):
        for controller in found:
            if reported := _unknown(controller):
                message, help = reported
                note = (file.note,)
                yield Finding(Location(controller.type_at), message, help, related=note)


def _unknown(controller: Controller) -> tuple[str, str] | None:
    """Message and remedy for a type that does not exist; None for one that does or may."""
    kind, here = controller.type, classes(controller.ros)
    if kind in here:
        return None
    if controller.ros == 1:
        of_ros2 = kind in classes(2)
        message = f"controller '{controller.name}': {kind} is a class of ROS 2"
        return (message, "take the class of ros_controllers") if of_ros2 else None
    if suggested := successor(kind):
        message = f"controller '{controller.name}': no package of ROS 2 has {kind} any more"
        return message, f"take {suggested}, and see its parameters"
    package = kind.partition("/")[0]
    own = [name for name in here if name.startswith(f"{package}/")]
    if not own or nearest(kind, here, _TYPO):
        return None
    message = f"controller '{controller.name}': package {package} has no controller {kind}"
    return message, "it has: " + ", ".join(own)

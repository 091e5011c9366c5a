"""A parameter file of controllers names a joint that the model does not have.

The controller finds no interface of that name, cannot be activated, and the robot does not move:
"not in the list of available interfaces". Correct the name in the file. A controller none of whose
joints is in the model is taken for one of another variant of the robot, if other controllers fit,
or if the names differ in a prefix only.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
    ros-simulation/gazebo_ros_pkgs#1109: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1109
"""

from __future__ import annotations

from urdfkit.core.suggest import Suggester
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, rule
from urdfkit.ros.catalog.ros_control import controllers as catalogue
from urdfkit.ros.controllers import Controller
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.ros.ros_control import components
from urdfkit.text.diagnostic import Severity
from urdfkit.text.grammar import is_expression
from urdfkit.text.located_yaml import Value

BAD = ARM + CONTROL
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    arm:
      type: position_controllers/JointGroupPositionController
arm:
  ros__parameters:
    joints: [shoulder]
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"shoulder", b"sholder"),
    "config/good.yaml": _YAML,
}


@rule(Severity.ERROR, help="fix the name in the parameter file", reports_missing=True)
def check(subject: Subject) -> Findings:
    if subject.is_part:
        return
    known = set(subject.model.joints_by_name)
    for component in components(subject.model):  # a controller may command a GPIO, too
        known.update(part.name for part in component.parts)
    suggester = Suggester(known)
    for file, found in subject.controllers:
        named = [(controller, _joints(controller)) for controller in found]
        any_known = any(value.text in known for _, values in named for value in values)
        for controller, values in named:
            is_of_robot = any(value.text in known for value in values)
            for value in values:
                if value.text in known or (not is_of_robot and _is_prefixed(value.text, known)):
                    continue
                hint = suggester.hint(value.text)
                if is_of_robot or hint or not any_known:
                    yield Finding(
                        Location(value.span),
                        f"controller '{controller.name}' names joint '{value.text}', "
                        f"which is not in the model{hint}",
                        related=(file.note,),
                        alike="" if hint else file.path,
                    )


def _is_prefixed(name: str, known: set[str]) -> bool:
    """True if the model has that joint with another prefix: the file is for another variant."""
    return any(joint.endswith(name) or name.endswith(joint) for joint in known if joint)


def _joints(controller: Controller) -> list[Value]:
    """The names of joints; those with a slash are interfaces of other controllers."""
    kind = catalogue().get(controller.type)
    values = controller.values(kind.joints) if kind else []
    return [v for v in values if v.text and "/" not in v.text and not is_expression(v.text)]

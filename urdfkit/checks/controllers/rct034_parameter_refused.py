"""A parameter of a controller is of the wrong type, or no number above zero where it must be one.

ROS 2 types the parameters of a node: a controller that declares a `double` refuses the whole number
`50`, and everything in quotes is a string. The controller is then not loaded: "parameter
'publish_rate' has invalid type". A decimal comma makes a string of a number, too. Reported is
what all versions of a class since Humble agree on.

Sources:
    rclcpp, parameter types: https://docs.ros.org/en/rolling/Concepts/Basic/About-Parameters.html
    ros2_controllers: https://github.com/ros-controls/ros2_controllers
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.ros.catalog.controllers import Parameters, of_manager, parameters_of
from urdfkit.ros.controllers import ParameterFile, Section, controllers, managers
from urdfkit.ros.gazebo.samples import ARM, CONTROL
from urdfkit.ros.parameter_types import is_not_positive, type_of
from urdfkit.text.diagnostic import Severity
from urdfkit.text.located_yaml import Node, Value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = ARM + CONTROL
GOOD = BAD.replace("bad.yaml", "good.yaml")
_YAML = b"""\
controller_manager:
  ros__parameters:
    update_rate: 100
    arm:
      type: joint_trajectory_controller/JointTrajectoryController
arm:
  ros__parameters:
    joints: [shoulder]
    command_interfaces: [position]
    state_interfaces: [position]
    action_monitor_rate: 20.0
"""
FILES = {
    "config/bad.yaml": _YAML.replace(b"20.0", b"20"),
    "config/good.yaml": _YAML,
}

_WORDS = {
    "bool": "true or false",
    "int": "a whole number",
    "double": "a number with a point",
    "string": "a text",
    "bool_array": "a list of true and false",
    "int_array": "a list of whole numbers",
    "double_array": "a list of numbers with a point",
    "string_array": "a list of texts",
}


@rule("RCT034", "parameter-refused", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    for file, section in managers(subject):
        yield from _refused("the controller manager", of_manager(), section, file)
    for file, found in controllers(subject):
        for one in found:
            known = parameters_of(one.type, one.ros)
            if known is not None:
                yield from _refused(f"controller '{one.name}'", known, one.section, file)


def _refused(
    owner: str, known: Parameters, section: Section, file: ParameterFile
) -> Iterator[Finding]:
    note = (file.note,)
    for name, node in section.given.items():
        wanted, kind = known.type_of(name), type_of(node)
        place = Location(section.places[name] if isinstance(node, list) else node.span)
        if wanted and kind and kind != wanted:
            yield Finding(
                place,
                f"{owner} refuses {name}: it is {_WORDS[kind]}, and must be {_WORDS[wanted]}",
                _remedy(node, wanted),
                related=note,
            )
        elif name in known.positive and isinstance(node, Value) and is_not_positive(node):
            message = f"{owner}: {name} is {node.text}, and must be above 0"
            yield Finding(place, message, related=note)


def _remedy(node: Node, wanted: str) -> str:
    """What to write instead."""
    if isinstance(node, Value) and wanted in ("double", "int"):
        try:
            number = float(node.text.replace(",", "."))
        except ValueError:
            pass
        else:
            if wanted == "double":
                return f"write {number}"
            if number.is_integer():
                return f"write {int(number)}"
    return f"write {_WORDS[wanted]}"

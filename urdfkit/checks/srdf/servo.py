"""Unknown groups, frames and controllers, and invalid values, in the files of MoveIt Servo.

Source: ``servo_calcs.cpp`` and ``servo_parameters.cpp`` of moveit_servo (Humble), ``servo.cpp`` and
``servo_parameters.yaml`` (Jazzy).
"""

import os

from urdfkit.checks.srdf.trajectory_controllers import defined_controllers
from urdfkit.core.suggest import did_you_mean
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog.controllers import of_servo
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_variant import names_of_other_robots
from urdfkit.ros.parameter_types import TYPES, correction, is_not_positive, type_of
from urdfkit.text.located_yaml import Value
from urdfkit.workspace.manifest import manifest_of

_GROUP, _TOPIC = "move_group_name", "command_out_topic"
#: In Humble and before; later Servo takes frames from its commands.
_FRAMES = ("planning_frame", "ee_frame_name", "robot_link_command_frame")
_OUTPUTS = ("joint_trajectory", "commands")
_MAX_NAMED = 4


def unknown_in_servo(context: Context, srdf: Srdf) -> Findings:
    above = {joint.get("parent_frame") or "" for joint in srdf.root.all("virtual_joint")}
    for source, values in context.moveit_config.servo_values():
        file = os.path.basename(source.path)
        known = {_GROUP: srdf.known("group"), **dict.fromkeys(_FRAMES, srdf.known("link") | above)}
        written = {key: values[key].text for key in known if key in values}
        lost = {name for key, name in written.items() if name and name not in known[key]}
        lost -= names_of_other_robots(context, srdf, lost)
        for key, name in written.items():
            if name in lost and known[key]:
                message = f"{file}: unknown {key} '{name}'{did_you_mean(name, known[key])}"
                help = f"write one of {few(sorted(known[key]), _MAX_NAMED)}"
                yield Finding(values[key].span, message, help, severity=Severity.WARNING)
        if _TOPIC in values:
            yield from _unknown_controller(context, srdf, values[_TOPIC])
        manifest = manifest_of(context.resolver, source.path)
        yield from _invalid_values(
            file, values, is_ros_2=manifest is not None and manifest.ros == 2
        )


def _invalid_values(file: str, values: dict[str, Value], *, is_ros_2: bool) -> Findings:
    """Parameters that Servo requires, and values at which it stops."""
    known = of_servo()
    for name in known.required:
        if name not in values and _TOPIC in values:
            message = f"{file}: required parameter {name} is missing"
            yield Finding(values[_TOPIC].span, message, f"add {name}: ...")
    for name, value in values.items():
        expected, actual = known.type_of(name), type_of(value)
        words = known.words_of(name)
        if is_ros_2 and expected and actual and actual != expected:
            message = f"{file}: {name} is {TYPES[actual]}, must be {TYPES[expected]}"
            yield Finding(value.span, message, correction(value, expected))
        elif words and value.text not in words:
            message = f"{file}: {name} is '{value.text}'{did_you_mean(value.text, words)}"
            yield Finding(value.span, message, f"write one of {', '.join(words)}")
        elif name in known.positive and is_not_positive(value):
            message = f"{file}: {name} is {value.text}, must be > 0"
            yield Finding(value.span, message, "write a positive number")


def _unknown_controller(context: Context, srdf: Srdf, topic: Value) -> Findings:
    """A topic that no controller of the workspace reads."""
    owner, _, output = topic.text.strip("/").rpartition("/")
    name = owner.rpartition("/")[2]
    defined = {controller.name: controller for controller in defined_controllers(context, srdf)}
    users = [controller.name for controller in defined.values() if controller.values(["joints"])]
    moving = [user for user in users if "broadcaster" not in defined[user].type]
    if name and output in _OUTPUTS and name not in defined and moving:
        yield Finding(
            topic.span,
            f"{_TOPIC} is of controller '{name}', which no parameter file of ros2_control defines"
            f"{did_you_mean(name, moving)}",
            f"name a controller that is defined: {few(sorted(moving), _MAX_NAMED)}",
            severity=Severity.WARNING,
        )

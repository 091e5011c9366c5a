"""A file of MoveIt Servo contains an unknown name or topic, or an invalid value.

- An unknown group or frame, or the topic of a controller that is not defined, or that reads another
  topic or type (warnings): the robot does not follow the commands.
- A parameter is missing, or has another type or an invalid value: Servo stops.

Sources:
    MoveIt, Servo: https://moveit.picknik.ai/main/doc/examples/realtime_servo/realtime_servo_tutorial.html
    MoveIt, servo_parameters.yaml: https://github.com/moveit/moveit2/blob/main/moveit_ros/moveit_servo/config/servo_parameters.yaml
"""

import os

from urdfkit.checks.srdf.namesakes import names_in_namesakes
from urdfkit.checks.srdf.trajectories import defined_controllers
from urdfkit.core.suggest import did_you_mean
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.controllers import of_servo
from urdfkit.ros.gazebo.samples import SHOULDER
from urdfkit.ros.moveit.samples import configurations, named_xml
from urdfkit.ros.moveit.srdf import Srdf
from urdfkit.ros.moveit.srdf_variant import names_of_other_robots
from urdfkit.ros.parameter_types import TYPES, correction, is_not_positive, type_of
from urdfkit.text.located_yaml import Value
from urdfkit.workspace.manifest import manifest_of

BAD = named_xml("bad", SHOULDER)
GOOD = BAD.replace('"bad"', '"good"')
_SERVO = """\
move_group_name: manipulator
command_out_topic: /arm_controller/joint_trajectory
command_out_type: trajectory_msgs/JointTrajectory
"""
FILES = configurations("servo.yaml", _SERVO, _SERVO.replace("manipulator", "arm"))

_GROUP, _TOPIC, _TYPE = "move_group_name", "command_out_topic", "command_out_type"
#: In Humble and before; later Servo takes frames from its commands.
_FRAMES = ("planning_frame", "ee_frame_name", "robot_link_command_frame")
_OUTPUTS = ("joint_trajectory", "commands")
#: Most names that a help lists.
_MAX_NAMED = 4


@rule(Severity.ERROR, needs=(Need.MODEL, Need.SRDF), reports_missing=True)
def check(context: Context) -> Findings:
    srdf = context.required_srdf
    yield from _unknown_names(context, srdf)
    yield from _mismatched_topics(context, srdf)


def _unknown_names(context: Context, srdf: Srdf) -> Findings:
    above = {joint.get("parent_frame") or "" for joint in srdf.root.all("virtual_joint")}
    for source, values in context.moveit_config.servo_values():
        file = os.path.basename(source.path)
        known = {_GROUP: srdf.known("group"), **dict.fromkeys(_FRAMES, srdf.known("link") | above)}
        written = {key: values[key].text for key in known if key in values}
        lost = {name for key, name in written.items() if name and name not in known[key]}
        lost -= names_of_other_robots(context, srdf, lost)
        lost -= names_in_namesakes(context, srdf) if lost else set()
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


def _mismatched_topics(context: Context, srdf: Srdf) -> Findings:
    """A topic that its controller does not read, and a type that it does not read."""
    types: dict[str, str] = data("moveit")["servo_outputs"]
    for source, values in context.moveit_config.servo_values():
        topic, kind = (values.get(name) for name in (_TOPIC, _TYPE))
        file = os.path.basename(source.path)
        if topic is not None and (read := _read_topic(context, srdf, topic.text)):
            message = f"{file}: '{topic.text}' is not read: the controller reads '{read}'"
            yield Finding(topic.span, message, f"write {read}", severity=Severity.WARNING)
            continue
        expected = types.get(topic.text.rpartition("/")[2]) if topic else None
        if kind is None or topic is None or not expected or kind.text == expected:
            continue
        message = f"{file}: command_out_type is '{kind.text}', but {topic.text} is {expected}"
        yield Finding(kind.span, message, f"write {expected}", severity=Severity.WARNING)


def _read_topic(context: Context, srdf: Srdf, topic: str) -> str:
    """The topic that a controller reads instead of another one below its name."""
    above, _, last = topic.rpartition("/")
    name = above.rpartition("/")[2]
    kinds = {
        controller.type
        for controller in defined_controllers(context, srdf)
        if controller.name == name
    }
    expected = data("moveit")["servo_topics"].get(kinds.pop()) if len(kinds) == 1 else None
    return f"{above}/{expected}" if expected and expected != last else ""

"""Inconsistent parameters of a joint_trajectory_controller.

Sources: ``validate_jtc_parameters.hpp`` and ``joint_trajectory_controller.cpp`` of
ros2_controllers, Humble to Rolling.
"""

from collections.abc import Iterator

from urdfkit.core.suggest import did_you_mean
from urdfkit.core.words import few
from urdfkit.ros.controllers import Controller, Section
from urdfkit.text.located_yaml import Value
from urdfkit.text.source import Span

_TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
_LISTS = ("joints", "command_interfaces", "state_interfaces")
#: Parameters with a section for each joint.
_OF_JOINTS = ("constraints", "gains")
#: State interfaces that require another one.
_REQUIRED = {"velocity": "position", "acceleration": "velocity"}

#: Place, message and help.
_Problem = tuple[Span, str, str]


def invalid_interfaces(controller: Controller) -> Iterator[_Problem]:
    """Lists of joints or interfaces that the controller rejects."""
    if controller.type != _TRAJECTORY:
        return
    for name in _LISTS:
        yield from _repeated(controller, name)
    states = [value.text for value in controller.section.values("state_interfaces")]
    for state in states:
        if (required := _REQUIRED.get(state)) and required not in states:
            message = f"state_interfaces has {state} without {required}"
            yield controller.section.places["state_interfaces"], message, f"add {required}"


def unread_joints(controller: Controller) -> Iterator[_Problem]:
    """Tolerances and gains of joints that the controller does not have, which it ignores."""
    joints = {value.text for value in controller.values(["joints", "command_joints"])}
    if controller.type != _TRAJECTORY or not joints:
        return
    seen: set[str] = set()
    for name, place in controller.section.places.items():
        section, _, inner = name.partition(".")
        joint, dot, _ = inner.partition(".")
        if section in _OF_JOINTS and dot and joint not in joints and joint not in seen:
            seen.add(joint)
            message = f"{section} of '{joint}' are not read: it is not in joints"
            yield (
                place,
                message + did_you_mean(joint, joints),
                f"name one of {few(sorted(joints), 6)}",
            )


def repeated_joints(controller: Controller) -> Iterator[_Problem]:
    """A joint that a controller of ROS 1 has twice: it then lacks another one."""
    if controller.ros == 1 and controller.type.endswith(_TRAJECTORY.partition("/")[2]):
        yield from _repeated(controller, _LISTS[0])


def _repeated(controller: Controller, name: str) -> Iterator[_Problem]:
    values = controller.section.values(name)
    first: dict[str, Value] = {}
    for value in values:
        if first.setdefault(value.text, value) is not value:
            yield value.span, f"{name} has '{value.text}' twice", "remove one of the two"
            return


def without_gains(controller: Controller, own: Section) -> Iterator[_Problem]:
    """Commands that a PID computes without gains, which are then 0."""
    commands = [value.text for value in controller.section.values("command_interfaces")]
    if controller.type != _TRAJECTORY or commands not in (["effort"], ["velocity"]):
        return
    (command,) = commands
    is_open = any(value.boolean for value in own.values("open_loop_control"))
    if any(name.startswith("gains") for name in own.places) or (is_open and command == "velocity"):
        return
    message = f"command interface {command} requires gains, which are 0 by default"
    help = "add gains: {JOINT: {p: ..., i: ..., d: ...}} for each joint"
    yield controller.section.places["command_interfaces"], message, help

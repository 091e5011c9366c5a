"""A transmission, `<ros2_control>` or a controller names a joint that the robot does not have.

- `<ros2_control>`: from ROS 2 Jazzy on, the controller manager stops with an exception; the
  simulators of Humble ignore the joint. `<param name="mimic">` must name another joint of the
  block. So must a parameter of the hardware, if its left or right counterpart does.
- A transmission of ROS 1: the whole hardware of gazebo_ros_control fails, so that no joint moves.
- A controller in a parameter file: it cannot be activated ("not in the list of available
  interfaces"). A controller without any joint of the robot is assumed to belong to another variant
  if other controllers fit, or if the names differ only in a prefix; but not if the others drive
  all joints of the robot except one, nor if launch files certainly start it with this robot. So it
  is if launch files load the file for a robot that has its joints, and start this one without it.
  A file of many joints, none of which the robot has, is one finding: it is for another robot. So is
  the file of a robot that launch files start, if they do not start this one (a warning). A joint
  that an argument of the robot disables is not reported: nothing may start the controller. A
  warning in ROS 1, where hardware may use other names, unless the hardware is a Gazebo plugin and
  the controller has other joints of the robot or a misspelt one. If it is for the other side of the
  robot, the one joint without a counterpart is a warning.

Correct the name.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    gazebo_ros_control_plugin.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/gazebo_ros_control_plugin.cpp
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
    ros-simulation/gazebo_ros_pkgs#1109: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1109
    PilzDE/pilz_robots#16: https://github.com/PilzDE/pilz_robots/issues/16
"""

from __future__ import annotations

import os
from collections.abc import Iterator

from urdfkit.checks.ros2_control.started_robots import (
    is_of_other_robot,
    is_spawned_without,
    started_robot_of,
)
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.core.suggest import TYPO, Suggester, did_you_mean, hint_for, nearest
from urdfkit.core.words import listed
from urdfkit.lint.misspelt_names import corrected_definition
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.lint.switched_off import is_switched_off
from urdfkit.robot.assets.file_names import is_mistyped
from urdfkit.robot.joint_limits import can_move
from urdfkit.robot.samples import robot_xml
from urdfkit.robot.symmetry import pairs
from urdfkit.ros.controllers import Controller, ParameterFile
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml, driven_xml
from urdfkit.ros.ros_control import (
    called,
    components,
    control_plugins,
    driven_joints,
    joints_and_owners,
    parameter,
)
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression
from urdfkit.text.located_yaml import Value

#: Values of ``mimic`` since ROS 2 Iron; before, it is the name of a joint.
_SWITCH = ("true", "false")
#: Joints of a file, all unknown, from which it is for another robot.
_MANY = 4
#: Most unknown joints that the message about a file names.
_MOST_NAMED = 4
_BROADCASTER = "joint_state_broadcaster/JointStateBroadcaster"

BAD = robot_xml(SHOULDER, control_xml("mock_components/GenericSystem", driven_xml("sholder")))
FIXED = GOOD = BAD.replace("sholder", "shoulder")


@rule(
    Severity.ERROR,
    help="fix the name, or add the joint",
    reports_missing=True,
    depends_on_arguments=True,
)
def check(context: Context) -> Findings:
    known = context.model.joints_by_name
    # A robot without joints describes only the hardware: the joints are in the world of Webots.
    if known and not context.is_part:
        yield from _unknown_joints(context, Suggester(known))
    yield from _not_in_block(context)
    yield from _unknown_leaders(context)
    yield from _unlike_counterpart(context)
    if not context.is_part:
        yield from _controller_joints(context)


def _unknown_joints(context: Context, suggester: Suggester) -> Findings:
    entries = list(joints_and_owners(context))
    listed = {(joint.parent and joint.parent.tag, joint.get("name")) for joint, _ in entries}
    for joint, owner in entries:
        name = joint.attributes.get("name")
        if name is None or name.value in context.model.joints_by_name or is_expression(name.value):
            continue
        hint = suggester.hint(name.value)
        suggested = suggester.suggested(name.value)
        entry = (joint.parent and joint.parent.tag, suggested)
        if entry in listed and not is_mistyped(name.value, suggested):
            hint = suggested = ""  # it has an entry of its own
        message = f"{owner}: unknown joint '{name.value}'{hint}"
        defined = context.model.joints_by_name.get(suggested)
        fix = corrected_definition(context, defined, name.value) or fix_value(name, suggested)
        help = ""
        if _is_actuator(joint):
            message = f"{owner}: '{name.value}' is an actuator, not a joint of the robot"
            help, fix = "remove the <joint>, and move its parameters into <hardware>", None
        yield Finding(name, message, help, fix, group_key="" if hint else owner)


def _is_actuator(joint: Element) -> bool:
    """True for an actuator of a transmission that has a ``<joint>`` of its own, for parameters."""
    block, name = joint.parent, joint.get("name")
    return block is not None and any(
        actuator.get("name") == name
        for transmission in block.all("transmission")
        for actuator in transmission.all("actuator")
    )


def _not_in_block(context: Context) -> Findings:
    """Joints of ROS 2 transmissions that are not in the same block."""
    for component in components(context.model):
        listed = {joint.name for joint in component.joints}
        for joint, transmission in driven_joints(component.at.all("transmission")):
            name = joint.attributes.get("name")
            if name and name.value not in listed and not is_expression(name.value):
                yield Finding(
                    name,
                    f"{called(transmission)}: joint '{name.value}' is not in {component.called}",
                    "list the joint in the same block, or correct the name",
                )


def _unknown_leaders(context: Context) -> Findings:
    """Parameters ``mimic`` of ROS 2 Humble that name no joint of the block."""
    for component in components(context.model):
        listed = [joint.name for joint in component.joints]
        for joint in component.joints:
            named = parameter(joint.at, "mimic")
            name = named.text.strip() if named else ""
            if named and name not in listed and name.lower() not in _SWITCH:
                message = f"joint '{joint.name}': mimicked joint '{name}' is not in "
                message += f"{component.called}{did_you_mean(name, listed)}"
                yield Finding(named, message, "list the joint in the same block, or fix the name")


def _unlike_counterpart(context: Context) -> Findings:
    """Parameters of the hardware of which only the left or the right one names a joint."""
    for component in components(context.model):
        parameters = component.at.child_or_self("hardware").all("param")
        values = {element.get("name") or "": element for element in parameters}
        listed = [joint.name for joint in component.joints]
        for pair in pairs(values):
            right, wrong = sorted(pair, key=lambda key: values[key].text.strip() not in listed)
            name = values[wrong].text.strip()
            is_known = values[right].text.strip() in listed
            if is_known and name not in listed and name.isidentifier():
                yield Finding(
                    values[wrong],
                    f"{component.called}: parameter '{wrong}' names no joint of the block, unlike "
                    f"'{right}': '{name}'{did_you_mean(name, listed)}",
                )


class _Use(Record):
    """The joints that a controller in a parameter file uses."""

    file: ParameterFile
    controller: Controller
    joints: list[Value]
    fits: bool  # True if the robot has one of them

    @property
    def named(self) -> tuple[str, set[str]]:
        """The names of the controller and of its joints."""
        return self.controller.name, {joint.text for joint in self.joints}


def _controller_joints(context: Context) -> Findings:
    known = set(context.model.joints_by_name)
    for component in components(context.model):  # a controller may also command a GPIO
        known.update(part.name for part in component.parts)
    known.update(_of_uncalled_macros(context))
    suggester = Suggester(known)
    joints = [(file, controller, _joints(controller)) for file, controller in context.controllers]
    uses = [_Use(*use, fits=any(joint.text in known for joint in use[-1])) for use in joints]
    fitting = {use.file.path for use in uses if use.fits}
    for path, of_file in by_key((use.file.path, use) for use in uses).items():
        is_fitting = path in fitting
        other = None if is_fitting else _of_another_robot(context, of_file, known, suggester)
        if other:
            yield other
            continue
        used = {joint.text for use in of_file for joint in use.joints}
        free = known - used
        rest = _only_free(context, used, known)
        unknown: list[str] = []
        found: list[Finding] = []
        for use in of_file:
            is_of_robot = (
                use.fits
                or _is_broadcaster_of_robot(use, uses)
                or (is_fitting and is_spawned_without(*use.named, context))
            )
            lacking = list(_unknown_to_robot(use, known, context, is_of_robot=is_of_robot))
            if lacking and not use.fits and is_of_other_robot(*use.named, path, context):
                continue
            for joint in lacking:
                hint = _hint(joint.text, use, suggester, free) or hint_for(rest)
                is_likely = is_of_robot or bool(hint)
                if is_likely or not is_fitting:
                    unknown.append(joint.text)
                    found.append(_unknown_joint(use, joint, hint, context, is_likely=is_likely))
            found += [] if is_of_robot else _unlike_other_side(use, known)
        robot = started_robot_of(path, set(unknown), context) if found else ""
        yield from [_of_started_robot(of_file[0].file, unknown, robot)] if robot else found


def _unlike_other_side(use: _Use, known: set[str]) -> Findings:
    """The only joint of the controller of the other side whose counterpart the robot lacks."""
    names = {joint.text for joint in use.joints}
    paired = {name for pair in pairs(sorted(names | known)) for name in pair} & names
    if len(names - paired) == 1 and len(paired) >= _MANY and names.isdisjoint(known):
        joint = next(joint for joint in use.joints if joint.text not in paired)
        yield Finding(
            joint.span,
            f"{use.controller.title}: the robot has the counterparts of its {len(paired)} other "
            f"joints, but none of '{joint.text}'",
            "fix the name in the parameter file",
            related=(use.file.note,),
            severity=Severity.WARNING,
        )


def _of_started_robot(file: ParameterFile, unknown: list[str], robot: str) -> Finding:
    """The finding about a file for another robot, of which the checked one may be an old copy."""
    names = listed([f"'{name}'" for name in dict.fromkeys(unknown)], _MOST_NAMED)
    return Finding(
        file.span,
        f"{os.path.basename(file.path)} is for {os.path.basename(robot)}, which launch files start:"
        f" this robot has no joint {names}",
        "name a parameter file with the joints of this robot",
        severity=Severity.WARNING,
    )


def _only_free(context: Context, used: set[str], known: set[str]) -> str:
    """The joint without a controller, if all others that move have one; for the unknown joint."""
    joints = [joint for joint in context.model.joints if can_move(joint) and joint.mimic is None]
    free = [joint.name for joint in joints if joint.name not in used]
    is_whole = len(joints) >= _MANY and len(free) == len(used - known) == 1
    return free[0] if is_whole else ""


def _hint(name: str, use: _Use, suggester: Suggester, free: set[str]) -> str:
    """The joint that is probably meant, which the controller does not list already."""
    suggested = suggester.suggested(name)
    if suggested in {joint.text for joint in use.joints} and not is_mistyped(name, suggested):
        suggested = nearest(name, sorted(free), TYPO) or ""
    return hint_for(suggested or _with_other_words(name, free))


def _of_uncalled_macros(context: Context) -> Iterator[str]:
    """Names in calls of macros without the xacro: prefix (XAC002), which may be those of joints."""
    expanded = context.reading.xacro
    macros = {macro.name for macro in expanded.macros} if expanded else ()
    for element in context.document.root.children if macros else ():
        name = element.get("name") if element.tag in macros else None
        if name:
            yield name


def _with_other_words(name: str, free: set[str]) -> str:
    """The joint without a controller whose name begins or ends the unknown one, or the reverse."""
    found = [
        other
        for other in free
        for short, long in (sorted((name, other), key=len),)
        if long.startswith(f"{short}_") or long.endswith(f"_{short}")
    ]
    return found[0] if len(found) == 1 else ""


def _is_broadcaster_of_robot(use: _Use, uses: list[_Use]) -> bool:
    """True for a broadcaster in the file of the robot's other controllers."""
    foreign = [other for other in uses if other.joints and not other.fits]
    is_only = len(foreign) == 1 and foreign[0] is use
    reads_joints = bool(use.controller.values(["interfaces"]))
    return use.controller.type == _BROADCASTER and is_only and reads_joints


def _unknown_to_robot(
    use: _Use, known: set[str], context: Context, *, is_of_robot: bool
) -> Iterator[Value]:
    """The joints that the robot lacks, and has with no other prefix or argument."""
    for joint in use.joints:
        is_prefixed = _is_prefixed(joint.text, known)
        is_of_variant = not is_of_robot if is_prefixed else is_switched_off(context, joint.text)
        if joint.text not in known and not is_of_variant:
            yield joint


def _unknown_joint(
    use: _Use, joint: Value, hint: str, context: Context, *, is_likely: bool
) -> Finding:
    # Hardware of ROS 1 may have joints of its own, unless it is Gazebo.
    is_certain = use.controller.ros != 1 or (is_likely and bool(control_plugins(context.model)))
    return Finding(
        joint.span,
        f"{use.controller.title}: unknown joint '{joint.text}'{hint}",
        "fix the name in the parameter file",
        related=(use.file.note,),
        group_key="" if hint else use.file.path,
        severity=None if is_certain else Severity.WARNING,
    )


def _of_another_robot(
    context: Context, uses: list[_Use], known: set[str], suggester: Suggester
) -> Finding | None:
    """The finding about a file with many joints, all of another robot; None if some may fit."""
    joints = [joint for use in uses for joint in use.joints]
    names = {joint.text for joint in joints}
    misspelt = sum(bool(suggester.suggested(name)) for name in names)
    if len(names) < _MANY or 2 * misspelt > len(names):
        return None
    if any(_is_prefixed(name, known) or is_switched_off(context, name) for name in names):
        return None
    robot = Related(context.document.root.span, "compared with this robot")
    return Finding(
        min((joint.span for joint in joints), key=lambda span: span.start),
        f"none of the {len(names)} joints of the controllers is a joint of the robot",
        "load the parameters of this robot, or start the robot that has these joints",
        related=(uses[0].file.note, robot),
        severity=Severity.WARNING if uses[0].controller.ros == 1 else None,
    )


def _is_prefixed(name: str, known: set[str]) -> bool:
    """True if the model has the joint with another prefix: the file is for another variant."""
    return any(joint.endswith(name) or name.endswith(joint) for joint in known if joint)


def _joints(controller: Controller) -> list[Value]:
    """The joints of a controller; names with a slash are interfaces of other controllers."""
    kind = controller.kind
    values = controller.values(kind.joints) if kind else []
    return [v for v in values if v.text and "/" not in v.text and not is_expression(v.text)]

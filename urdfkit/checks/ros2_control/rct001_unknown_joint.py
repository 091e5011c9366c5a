"""A transmission, `<ros2_control>` or a controller names a joint that the robot does not have.

- `<ros2_control>`: from ROS 2 Jazzy on, the controller manager stops with an exception; the
  simulators of Humble ignore the joint. `<param name="mimic">` must name another joint of the
  block.
- A transmission of ROS 1: the whole hardware of gazebo_ros_control fails, so that no joint moves.
- A controller in a parameter file: it cannot be activated ("not in the list of available
  interfaces"). A controller without any joint of the robot is assumed to belong to another variant
  if other controllers fit, or if the names differ only in a prefix. A file of many joints, none of
  which the robot has, is one finding: it is for another robot. A joint that an argument of the
  robot disables is not reported: nothing may start the controller. A warning in ROS 1, where
  hardware may use other names, unless the hardware is a Gazebo plugin and the controller has other
  joints of the robot or a misspelt one.

Correct the name.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    gazebo_ros_control_plugin.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/gazebo_ros_control_plugin.cpp
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
    ros-simulation/gazebo_ros_pkgs#1109: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1109
    PilzDE/pilz_robots#16: https://github.com/PilzDE/pilz_robots/issues/16
"""

from urdfkit.core.suggest import Suggester, did_you_mean
from urdfkit.lint.misspelt_names import corrected_definition
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.lint.switched_off import is_switched_off
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.controllers import Controller
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml, driven_xml
from urdfkit.ros.ros_control import (
    called,
    components,
    control_plugins,
    driven_joints,
    joints_and_owners,
    parameter,
)
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression
from urdfkit.text.located_yaml import Value

#: Values of ``mimic`` since ROS 2 Iron; before, it is the name of a joint.
_SWITCH = ("true", "false")
#: Joints of a file, all unknown, from which it is for another robot.
_MANY = 4
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
    if not context.is_part:
        yield from _controller_joints(context)


def _unknown_joints(context: Context, suggester: Suggester) -> Findings:
    for joint, owner in joints_and_owners(context):
        name = joint.attributes.get("name")
        if name is None or name.value in context.model.joints_by_name or is_expression(name.value):
            continue
        hint = suggester.hint(name.value)
        message = f"{owner}: unknown joint '{name.value}'{hint}"
        suggested = suggester.suggested(name.value)
        defined = context.model.joints_by_name.get(suggested)
        fix = corrected_definition(context, defined, name.value) or fix_value(name, suggested)
        yield Finding(name, message, fix=fix, group_key="" if hint else owner)


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


def _controller_joints(context: Context) -> Findings:
    known = set(context.model.joints_by_name)
    for component in components(context.model):  # a controller may also command a GPIO
        known.update(part.name for part in component.parts)
    suggester = Suggester(known)
    in_gazebo = bool(control_plugins(context.model))
    joints = [(file, controller, _joints(controller)) for file, controller in context.controllers]
    fitting = {file.path for file, _, values in joints if _has_any(values, known)}
    foreign = {id(user) for _, user, values in joints if values and not _has_any(values, known)}
    for file in {file.path: file for file, _, _ in joints if file.path not in fitting}.values():
        of_file = [(user, values) for one, user, values in joints if one.path == file.path]
        if found := _of_another_robot(context, of_file, known, suggester):
            robot = Related(context.document.root.span, "compared with this robot")
            yield found._replace(related=(file.note, robot))
            joints = [one for one in joints if one[0].path != file.path]
    for file, controller, values in joints:
        is_broadcaster = controller.type == _BROADCASTER and foreign == {id(controller)}
        # It is in the file of the robot's other controllers; without interfaces it reads no joints.
        is_of_robot = _has_any(values, known) or (
            is_broadcaster and bool(controller.values(["interfaces"]))
        )
        for value in values:
            is_prefixed = _is_prefixed(value.text, known)
            if value.text in known or (is_prefixed and not is_of_robot):
                continue
            if not is_prefixed and is_switched_off(context, value.text):
                continue
            hint = suggester.hint(value.text)
            is_certain = controller.ros != 1 or (in_gazebo and (is_of_robot or bool(hint)))
            if is_of_robot or hint or file.path not in fitting:
                yield Finding(
                    value.span,
                    f"controller '{controller.name}': unknown joint '{value.text}'{hint}",
                    "fix the name in the parameter file",
                    related=(file.note,),
                    group_key="" if hint else file.path,
                    severity=None if is_certain else Severity.WARNING,
                )


def _of_another_robot(
    context: Context,
    joints: list[tuple[Controller, list[Value]]],
    known: set[str],
    suggester: Suggester,
) -> Finding | None:
    """The finding about a file with many joints, all of another robot; None if some may fit."""
    values = [value for _, of_controller in joints for value in of_controller]
    names = {value.text for value in values}
    misspelt = sum(bool(suggester.suggested(name)) for name in names)
    if len(names) < _MANY or 2 * misspelt > len(names):
        return None
    if any(_is_prefixed(name, known) or is_switched_off(context, name) for name in names):
        return None
    return Finding(
        min((value.span for value in values), key=lambda span: span.start),
        f"none of the {len(names)} joints of the controllers is a joint of the robot",
        "load the parameters of this robot, or start the robot that has these joints",
        severity=Severity.WARNING if joints[0][0].ros == 1 else None,
    )


def _has_any(values: list[Value], names: set[str]) -> bool:
    return any(value.text in names for value in values)


def _is_prefixed(name: str, known: set[str]) -> bool:
    """True if the model has the joint with another prefix: the file is for another variant."""
    return any(joint.endswith(name) or name.endswith(joint) for joint in known if joint)


def _joints(controller: Controller) -> list[Value]:
    """The joints of a controller; names with a slash are interfaces of other controllers."""
    kind = controller.kind
    values = controller.values(kind.joints) if kind else []
    return [v for v in values if v.text and "/" not in v.text and not is_expression(v.text)]

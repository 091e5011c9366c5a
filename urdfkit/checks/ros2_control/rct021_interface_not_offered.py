"""A controller requires an interface that the robot's joints do not offer.

The controller manager cannot activate the controller: "not in the list of available interfaces".
Add the command or state interface to the joint if the hardware has it, or configure the controller
without it: `position_feedback: false` or `open_loop: true` of a wheel controller,
`state_interfaces` of a trajectory controller, `interfaces` of joint_state_broadcaster,
`max_effort_interface` of a gripper controller. A joint with a command interface for its position,
velocity or effort but no state interface is reported even without a controller (warning): most
controllers do not start, and the joint is missing in the joint states. A joint without any
`<ros2_control>` is reported only if the hardware offers all others of its controller, or the joint
that it mimics. If a file defines several controllers of a joint, one with available interfaces is
enough: a launch file starts only some of them. In ROS 1, Gazebo offers the `<hardwareInterface>` of
the joint's transmission.

Simulators and mock hardware offer exactly the listed interfaces. Other hardware may offer more: a
warning, or an info if the joint lists no interface of that kind, or if the interface has a name of
its own, such as `position_des`.

Sources:
    ros2_control, resource_manager.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/resource_manager.cpp
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
    diff_drive_controller.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/diff_drive_controller/src/diff_drive_controller.cpp
    joint_trajectory_controller.cpp: https://github.com/ros-controls/ros2_controllers/blob/master/joint_trajectory_controller/src/joint_trajectory_controller.cpp
    gripper_action_controller_impl.hpp: https://github.com/ros-controls/ros2_controllers/blob/humble/gripper_controllers/include/gripper_controllers/gripper_action_controller_impl.hpp
"""

from __future__ import annotations

from collections.abc import Collection

from urdfkit.core.record import Record
from urdfkit.core.suggest import TYPO, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.ros.catalog.ros_control import simulated_hardware, words
from urdfkit.ros.claims import claims
from urdfkit.ros.controllers import Controller, ParameterFile
from urdfkit.ros.gazebo.samples import ARM, CONTROL, control_xml, controller_yaml, driven_xml
from urdfkit.ros.ros_control import Component, components, control_plugins, driven_joints
from urdfkit.text.located_yaml import Value

_DRIVEN = control_xml("gz_ros2_control/GazeboSimSystem", driven_xml("shoulder", "velocity"))
BAD = ARM + _DRIVEN + "\n" + CONTROL
GOOD = BAD.replace("bad.yaml", "good.yaml")
FILES = {
    f"config/{name}.yaml": controller_yaml(
        f"{kind}/JointGroup{type}Controller", "joints: [shoulder]"
    )
    for name, kind, type in (
        ("bad", "effort_controllers", "Effort"),
        ("good", "velocity_controllers", "Velocity"),
    )
}

#: The control plugin of ROS 1.
_OF_ROS1 = "gazebo_ros_control"
_GRIPPER = "GripperActionController"
_DRIVE = "diff_drive_controller/DiffDriveController"
_BROADCASTER = "joint_state_broadcaster/JointStateBroadcaster"

#: Parameters that list the state interfaces; others, such as forward controllers, claim none.
_STATES = {
    _BROADCASTER: "interfaces",
    "joint_trajectory_controller/JointTrajectoryController": "state_interfaces",
    "admittance_controller/AdmittanceController": "state_interfaces",
}

#: Parameters of a gripper controller that name a further interface, as JOINT/INTERFACE.
_CLAIMED = ("max_effort_interface", "max_velocity_interface")

#: Hardware that offers only the listed interfaces, as the hardware of simulators does.
_MOCK = ("mock_components/GenericSystem", "fake_components/GenericSystem")

#: The interfaces that hardware of all kinds has.
_USUAL = frozenset(("position", "velocity", "acceleration", "effort"))

#: The interfaces of joints, by the names of the joints.
_Offered = dict[str, set[str]]


class _Demand(Record):
    """The interfaces that a controller requires of each of its joints."""

    controller: Controller
    file: ParameterFile
    needed: list[str]
    joints: list[Value]


@rule(Severity.ERROR, reports_missing=True)
def check(context: Context) -> Findings:
    yield from _without_command(context)
    states = _offered(context, "state")
    free = _may_offer_more(context)
    for file, controller in context.controllers:
        kind = controller.kind
        names = [name for name in kind.joints if name != "command_joints"] if kind else []
        demand = _Demand(controller, file, _states(controller), controller.values(names))
        yield from _missing(context, demand, states, free, "state")
    yield from _without_state(context)
    yield from _claimed_by_name(context, free)


def _claimed_by_name(context: Context, free: Collection[str]) -> Findings:
    """Command interfaces that a gripper controller claims besides the position of its joint."""
    offered = _offered(context, "command")
    for file, controller in context.controllers:
        own = [value.text for value in controller.values(["joint"])]
        is_gripper = controller.type.endswith(_GRIPPER) and not offered.keys().isdisjoint(own)
        for value in controller.values(_CLAIMED) if is_gripper else ():
            joint, _, interface = value.text.rpartition("/")
            available = offered.get(joint, set())
            if not joint and interface and own:
                yield Finding(
                    value.span,
                    f"{controller.title} requires command interface {interface}, which has no "
                    "joint: no interface has such a name",
                    f"write {own[0]}/{interface}",
                    related=(file.note,),
                )
            if not joint or interface in available:
                continue
            others = ", ".join(sorted(available)) or "none"
            yield Finding(
                value.span,
                f"{controller.title} requires command interface {interface} of joint "
                f"'{joint}', which offers: {others}",
                "remove the parameter, or add the <command_interface> to the joint",
                related=(file.note,),
                severity=_severity([interface], available) if joint in free else None,
            )


def _without_command(context: Context) -> Findings:
    by_ros = {1: _transmitted(context), 2: _offered(context, "command")}
    free = _may_offer_more(context)
    demands = [
        _Demand(user, file, *claim) for file, user in context.controllers for claim in claims(user)
    ]
    served = {  # another controller of the file has all of its interfaces of these joints
        (demand.file.path, value.text)
        for demand in demands
        for value in demand.joints
        if demand.needed
        and by_ros[demand.controller.ros].get(value.text, set()).issuperset(demand.needed)
    }
    joints_of_all = [
        (demand.file.path, {value.text for value in demand.joints}) for demand in demands
    ]
    for demand in demands:
        path, ros = demand.file.path, demand.controller.ros
        own = {value.text for value in demand.joints}
        # Another controller of joints that the hardware offers is for the robot as it is.
        is_alternative = any(
            other == path and names & own and names <= by_ros[2].keys()
            for other, names in joints_of_all
        )
        if ros == 2 and not is_alternative:
            yield from _forgotten(context, demand, by_ros[2])
        left = [value for value in demand.joints if (path, value.text) not in served]
        free_joints = free if ros == 2 else frozenset()
        yield from _missing(
            context, demand._replace(joints=left), by_ros[ros], free_joints, "command"
        )


def _missing(
    context: Context, demand: _Demand, offered: _Offered, free: Collection[str], direction: str
) -> Findings:
    controller = demand.controller
    for value in demand.joints:
        available = offered.get(value.text)
        missing = [
            name for name in demand.needed if available is not None and name not in available
        ]
        if missing and available is not None:
            joint = context.model.joints_by_name.get(value.text)
            help = f"add the <{direction}_interface> to the joint, or change the controller"
            if controller.ros == 1:
                help = "change the <hardwareInterface> of its transmission, or the controller"
            if joint is not None and joint.mimic and direction == "command":
                help = f"name '{joint.leader}', which moves this joint, too, or remove it"
            yield Finding(
                value.span,
                f"{controller.title} requires {direction} interface "
                f"{', '.join(missing)} of joint '{value.text}', which offers: "
                + (", ".join(sorted(available)) or "none"),
                help,
                related=(demand.file.note,),
                severity=_severity(missing, available) if value.text in free else None,
            )


def _forgotten(context: Context, demand: _Demand, offered: _Offered) -> Findings:
    """The one joint of a controller that no ``<ros2_control>`` has, of hardware that is known."""
    joints, needed = demand.joints, demand.needed
    missing = [value for value in joints if value.text not in offered]
    others = [offered[value.text] for value in joints if value.text in offered]
    is_served = bool(needed) and all(names.issuperset(needed) for names in others)
    if len(missing) != 1 or not is_served:
        return
    joint = context.model.joints_by_name.get(missing[0].text)
    leader = joint.leader if joint and joint.mimic else ""
    follows = bool(leader) and offered.get(leader, set()).issuperset(needed)
    is_known = all(map(_offers_only_listed, components(context.model)))
    if not offered.keys() <= context.model.joints_by_name.keys():
        return  # the joint is there under another name, which RCT001 reports
    if joint and (follows or (others and is_known)):
        yield Finding(
            missing[0].span,
            f"{demand.controller.title} requires command interface {', '.join(needed)} of "
            f"joint '{missing[0].text}', which no <ros2_control> has",
            f"name '{leader}', which moves this joint, too"
            if follows
            else "add the joint to <ros2_control>, or remove it from the controller",
            related=(demand.file.note,),
            severity=None if is_known else Severity.WARNING,
        )


def _severity(missing: Collection[str], listed: Collection[str]) -> Severity:
    """Severity for a joint of hardware that may export unlisted interfaces.

    Who names an interface that no other hardware has knows the hardware, unless it is misspelt.
    """
    known = _USUAL | set(listed)
    is_own = all(
        "_" in name or (name not in known and not nearest(name, known, TYPO)) for name in missing
    )
    return Severity.WARNING if listed and not is_own else Severity.INFO


def _may_offer_more(context: Context) -> frozenset[str]:
    """The joints of hardware that may export unlisted interfaces."""
    return frozenset(
        part.name
        for component in components(context.model)
        for part in component.joints
        if not _offers_only_listed(component)
    )


def _offers_only_listed(component: Component) -> bool:
    return component.hardware in simulated_hardware() or component.hardware in _MOCK


def _without_state(context: Context) -> Findings:
    blocks = components(context.model)
    measured = {part.name for block in blocks for part in block.parts if part.of("state")}
    for block in blocks:
        for part in block.joints:
            # Hardware with other commands, as the pwm of a thruster, may measure nothing.
            is_usual = any(item.name in _USUAL for item in part.of("command"))
            if is_usual and part.name and part.name not in measured:
                message = f"joint '{part.name}' has command interfaces but no state interface"
                help = 'add <state_interface name="position"/>, and velocity if the hardware has it'
                yield Finding(part.at, message, help, severity=Severity.WARNING)


def _offered(context: Context, direction: str) -> _Offered:
    """The listed interfaces of a direction, by joint.

    Joints without interfaces are omitted if their hardware may export unlisted interfaces.
    """
    offered: _Offered = {}
    for component in components(context.model):
        for part in component.joints:
            if part.interfaces or _offers_only_listed(component):
                # gazebo_ros2_control offers position_pid as position, with its own PID.
                names = {interface.name.removesuffix("_pid") for interface in part.of(direction)}
                offered.setdefault(part.name, set()).update(names)
    return offered


def _transmitted(context: Context) -> _Offered:
    """Command interfaces that Gazebo offers in ROS 1, by joint; hardware may offer more."""
    if not any(plugin.kind == _OF_ROS1 for plugin in control_plugins(context.model)):
        return {}
    offered: _Offered = {}
    for joint, _ in driven_joints(context.model.transmissions):
        for interface in joint.all("hardwareInterface"):
            name = interface.text.strip().removeprefix("hardware_interface/")
            if name in words("transmission", "unprefixed"):
                kind = name.removesuffix("JointInterface").lower()
                offered.setdefault(joint.get("name") or "", set()).add(kind)
    return offered


def _states(controller: Controller) -> list[str]:
    """State interfaces that a controller requires of each joint; empty if unknown."""
    if controller.type == _DRIVE:
        if _has_value(controller, "open_loop", "true"):
            return []
        return ["velocity" if _has_value(controller, "position_feedback", "false") else "position"]
    if controller.type.endswith(_GRIPPER):
        return ["position", "velocity"]
    name = _STATES.get(controller.type)
    return [value.text for value in controller.values([name]) if value.text] if name else []


def _has_value(controller: Controller, name: str, word: str) -> bool:
    return any(value.text.lower() == word for value in controller.values([name]))

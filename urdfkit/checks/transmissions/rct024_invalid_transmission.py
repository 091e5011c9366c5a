"""A transmission of ROS 1 is incomplete, invalid, a duplicate, or in a robot of ROS 2.

ros_control ignores an invalid transmission, so that no controller finds the joint: "Could not find
resource". Reported are

- a missing name, `<type>`, `<joint>`, `<actuator>` or `<hardwareInterface>`. The type is an
  element; only the PR2 and Drake read it as an attribute, and Drake reads no interface: a
  transmission in the form of Drake is a warning. Genesis rejects the robot if one of the first four
  is missing (error), even a PR2.
  `<hardwareInterface>` must be in `<joint>`; up to ROS Indigo it was in `<actuator>`;
- a misspelt type or a type without its package, and a wrong number of joints or actuators for the
  type;
- a `mechanicalReduction` that is 0 or not a number, and misspelt elements, whose default is used;
  Gazebo's own hardware does not read the type, the actuators and the ratio (warning);
- two transmissions with the same name, of which the second is used, or for the same joint, usually
  a copy in which a name was not changed (warning). The class that a `<robotSimType>` names may
  read several of one name, one for each interface of a joint;
- transmissions in a robot of ROS 2, which does not read them: ros2_control has its own
  `<transmission>` inside `<ros2_control>` (info).

Sources:
    URDF, transmission: https://wiki.ros.org/urdf/XML/Transmission
    ros_control, transmission_parser.cpp: https://github.com/ros-controls/ros_control/blob/noetic-devel/transmission_interface/src/transmission_parser.cpp
    ros_control, transmission_interface_loader.cpp: https://github.com/ros-controls/ros_control/blob/noetic-devel/transmission_interface/src/transmission_interface_loader.cpp
    gazebo_ros_control, default_robot_hw_sim.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_ros_control/src/default_robot_hw_sim.cpp
    ros-controls/ros_control#177: https://github.com/ros-controls/ros_control/issues/177
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
"""

from collections.abc import Iterable

from urdfkit.core.suggest import CLOSE_TYPO, TYPO, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related, Severity, rule
from urdfkit.robot.samples import element_xml, robot_xml
from urdfkit.robot.values import number
from urdfkit.ros.catalog.ros_control import words
from urdfkit.ros.gazebo.samples import SHOULDER
from urdfkit.ros.ros_control import (
    DEFAULT_SIM,
    ROS1,
    called,
    control_plugins,
    is_of_pr2,
    reads_transmissions,
)
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import fix_tag, fix_value

BAD = robot_xml(
    SHOULDER,
    element_xml(
        'transmission name="shoulder_transmission"',
        "<type>transmission_interface/SimpleTransmission</type>",
        element_xml(
            'joint name="shoulder"',
            "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>",
        ),
        element_xml(
            'actuator name="shoulder_motor"', "<mechanicalReducton>50</mechanicalReducton>"
        ),
    ),
)
FIXED = GOOD = BAD.replace("Reducton", "Reduction")

_CHILDREN = {
    "transmission": ("type", "joint", "actuator"),
    "joint": ("hardwareInterface", "role", "offset", "mechanicalReduction"),
    "actuator": ("hardwareInterface", "role", "mechanicalReduction", "motorTorqueConstant"),
}
#: Number of joints, and of actuators, by type.
_COUNTS = {"SimpleTransmission": 1, "DifferentialTransmission": 2, "FourBarLinkageTransmission": 2}
#: Elements of a transmission that Gazebo reads.
_READ_BY_GAZEBO = ("type", "joint", "actuator", "hardwareInterface")
#: Places that a finding lists after the first.
_MAX_RELATED = 20


@rule(Severity.WARNING, by_target=dict.fromkeys(ROS1, Severity.ERROR))
def check(context: Context) -> Findings:
    transmissions = context.model.transmissions
    is_required = bool(context.targets.that("requires_whole_transmissions"))
    if is_required:
        yield from _incomplete(transmissions, Severity.ERROR)
    if not reads_transmissions(context.targets):
        yield _unread(*transmissions)
        return
    read = [transmission for transmission in transmissions if not is_of_pr2(transmission)]
    unread = Severity.WARNING if "classic-ros1" in context.targets.names else None
    may_be_attribute = context.targets.all_are("reads_type_attributes")
    are_interfaces_read = not context.targets.all_are("ignores_interfaces")
    for transmission in read:
        if may_be_attribute and "type" in transmission.attributes:
            continue
        if not is_required:
            severity = Severity.WARNING if _is_of_drake(transmission) else None
            yield from _incomplete([transmission], severity)
        if not are_interfaces_read:
            continue
        yield from _interfaces(transmission)
        yield from _type(transmission, unread)
        yield from _count(transmission, unread)
        for element in (transmission, *transmission.children):
            yield from _children(element, called(transmission), unread)
    yield from _duplicate_names(read, is_simulated=_is_simulated_otherwise(context))
    yield from _driven_twice(read)


def _unread(first: Element, *others: Element) -> Finding:
    """One finding for all transmissions: a robot has one for each joint."""
    more = f" and {len(others)} more" if others else ""
    return Finding(
        first,
        f"{called(first)}{more}: not read in ROS 2",
        "delete it, or move it into <ros2_control>",
        related=tuple(Related(other.span, called(other)) for other in others[:_MAX_RELATED]),
        severity=Severity.INFO,
    )


def _incomplete(transmissions: Iterable[Element], severity: Severity | None) -> Findings:
    for transmission in transmissions:
        if missing := _missing(transmission):
            yield Finding(
                transmission,
                f"{called(transmission)} has no {' and no '.join(missing)}",
                f"add {' and '.join(map(_how_to_add, missing))}",
                severity=severity,
            )


def _how_to_add(missing: str) -> str:
    if missing.startswith("<type>"):
        return "<type>transmission_interface/SimpleTransmission</type>"
    return f'{missing[:-1]} name="...">' if missing.startswith("<") else f"a {missing}"


def _missing(transmission: Element) -> list[str]:
    missing: list[str] = []
    if not transmission.get("name"):
        missing.append("name")
    if not _has_text(transmission, "type"):
        attribute = " (the attribute is ignored)" if "type" in transmission.attributes else ""
        of_drake = " (only Drake reads the attribute)" if _is_of_drake(transmission) else ""
        missing.append(f"<type>{of_drake or attribute}")
    misspelt = {
        nearest(child.tag, _CHILDREN["transmission"], TYPO) for child in transmission.children
    }
    missing += [
        f"<{tag}>"
        for tag in ("joint", "actuator")
        if transmission.child(tag) is None and tag not in misspelt
    ]
    missing += [
        f"name in its <{child.tag}>"
        for child in transmission.children
        if child.tag in ("joint", "actuator") and not child.get("name")
    ]
    return missing


def _is_of_drake(transmission: Element) -> bool:
    """True for the form of the examples of Drake: a type as an attribute, and no interface."""
    is_simple = (transmission.get("type") or "").endswith("SimpleTransmission")
    return is_simple and not any(part.tag == "hardwareInterface" for part in transmission.walk())


def _interfaces(transmission: Element) -> Findings:
    for joint in transmission.all("joint"):
        if _has_text(joint, "hardwareInterface") or transmission.child("type") is None:
            continue
        is_misplaced = any(_has_text(a, "hardwareInterface") for a in transmission.all("actuator"))
        yield Finding(
            joint,
            f"{called(transmission)}: joint '{joint.get('name') or ''}' has no <hardwareInterface>"
            + ("; the one in <actuator> is ignored" if is_misplaced else ""),
            "add <hardwareInterface>hardware_interface/...JointInterface</hardwareInterface> to "
            "the joint",
        )


def _has_text(element: Element, tag: str) -> bool:
    return any(child.text.strip() for child in element.all(tag))


def _type(transmission: Element, unread: Severity | None) -> Findings:
    element, known = transmission.child("type"), words("transmission", "types")
    name = element.text.strip() if element else ""
    if element is None or name in known:
        return
    full = next((kind for kind in known if kind.endswith(f"/{name}")), None)
    suggested = full or nearest(name, known, CLOSE_TYPO)
    if suggested and (full or abs(len(suggested) - len(name)) <= 2):
        fix = fix_value(element, suggested)
        message = "has no package name" if full else f"is unknown; did you mean '{suggested}'?"
        message = f"{called(transmission)}: type '{name}' {message}"
        yield Finding(element, message, f"write {suggested}", fix, severity=unread)


def _count(transmission: Element, unread: Severity | None) -> Findings:
    """Wrong numbers of joints or actuators."""
    element = transmission.child("type")
    kind = element.text.strip().rpartition("/")[2] if element else ""
    for tag in ("joint", "actuator"):
        parts = transmission.all(tag)
        if kind in _COUNTS and parts and len(parts) != _COUNTS[kind]:
            message = f"{len(parts)} <{tag}> elements; a {kind} has {_COUNTS[kind]}"
            help = "write one transmission per joint" if kind == "SimpleTransmission" else ""
            help = help or f"write {_COUNTS[kind]} <{tag}> elements"
            severity = unread if tag == "actuator" else None
            yield Finding(parts[-1], f"{called(transmission)}: {message}", help, severity=severity)


def _children(element: Element, who: str, unread: Severity | None) -> Findings:
    """Misspelt child elements, and invalid gear ratios."""
    for child in element.children:
        known = _CHILDREN.get(element.tag, ())
        suggested = nearest(child.tag, known, TYPO) if child.tag not in known else None
        if suggested:
            fix = fix_tag(child, suggested)
            message = f"{who}: unknown element <{child.tag}>; did you mean '{suggested}'?"
            severity = None if suggested in _READ_BY_GAZEBO else unread
            yield Finding(child, message, "fix the name of the element", fix, severity=severity)
        elif child.tag == "mechanicalReduction" and not number(child.text.strip()):
            shown = child.text.strip() or "empty"
            message = f"{who}: {child.tag} is {shown}, not a number other than 0"
            help = "write the gear ratio, such as 50"
            yield Finding(child, message, help, severity=unread)


def _is_simulated_otherwise(context: Context) -> bool:
    """True if a class other than Gazebo's default simulates the hardware."""
    kinds = (plugin.at.child("robotSimType") for plugin in control_plugins(context.model))
    return any(kind is not None and kind.text.strip() not in ("", DEFAULT_SIM) for kind in kinds)


def _duplicate_names(transmissions: Iterable[Element], *, is_simulated: bool) -> Findings:
    """Names of several transmissions.

    Args:
        is_simulated: True if transmissions of one joint may have one name.
    """
    names: dict[str, Attribute] = {}
    for transmission in transmissions:
        name = transmission.attributes.get("name")
        first = names.setdefault(name.value, name) if name else None
        if (
            name
            and first
            and first is not name
            and not (is_simulated and _is_for_same(name, first))
        ):
            message = f"duplicate transmission name '{name.value}'"
            yield _duplicate(name, message, "give it a unique name", first)


def _driven_twice(transmissions: Iterable[Element]) -> Findings:
    """Joints of several transmissions."""
    driven: dict[tuple[str, str], Attribute] = {}
    for joint in (joint for transmission in transmissions for joint in transmission.all("joint")):
        name = joint.attributes.get("name")
        keys = [(name.value, kind) for kind in _interface_types(joint)] if name else []
        firsts = [driven.setdefault(key, name) for key in keys if name]
        others = [first for first in firsts if first is not name]
        if name and others:
            message = f"joint '{name.value}' already has a transmission"
            help = "name the joint that this transmission drives, or delete one of the two"
            yield _duplicate(name, message, help, others[0])


def _is_for_same(name: Attribute, first: Attribute) -> bool:
    """True if two transmissions are for the same joints."""
    joints = ([joint.get("name") for joint in at.element.all("joint")] for at in (name, first))
    return next(joints) == next(joints)


def _duplicate(at: Attribute, message: str, help: str, first: Attribute) -> Finding:
    related = (Related(first.span, "first defined here"),)
    return Finding(at, message, help, related=related, severity=Severity.WARNING)


def _interface_types(joint: Element) -> list[str]:
    """The interfaces of a joint, each of which may have its own transmission."""
    return [element.text.strip().rpartition("/")[2] for element in joint.all("hardwareInterface")]

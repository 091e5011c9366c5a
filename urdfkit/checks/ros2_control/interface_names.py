"""Names of interfaces of joints and sensors."""

from collections.abc import Sequence

from urdfkit.core.suggest import TYPO, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.ros.catalog.ros_control import Hardware, simulated_hardware, words
from urdfkit.ros.ros_control import (
    DEFAULT_SIM,
    Component,
    ControlPart,
    Interface,
    components,
    control_plugins,
    driven_joints,
    is_of_pr2,
    reads_transmissions,
)
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value
from urdfkit.workspace.program_strings import strings_in_programs

_HELP = "correct the name of the interface"
#: The state interfaces of a simulated joint.
_SIMULATED_STATES = ("position", "velocity", "effort")


def invalid_interfaces(context: Context) -> Findings:
    """Misspelt interfaces, and interfaces that the simulator does not offer."""
    of_hardware: list[tuple[str, Finding]] = []
    for component in components(context.model):
        for part in component.parts:
            for interface in part.interfaces:
                findings = _interface(component, part, interface)
                if component.hardware in simulated_hardware():
                    yield from findings
                else:
                    of_hardware += ((interface.name, finding) for finding in findings)
    # Hardware of the workspace may export interfaces with names of its own.
    names = {name for name, _ in of_hardware}
    exported = strings_in_programs(names, context.source.path, context.resolver)
    yield from (finding for name, finding in of_hardware if name not in exported)
    if context.model.transmissions and reads_transmissions(context.targets):
        yield from _hardware_interfaces(context)


def _interface(component: Component, part: ControlPart, interface: Interface) -> Findings:
    name = interface.name
    if not name or part.kind == "gpio":
        return
    simulated = simulated_hardware().get(component.hardware)
    is_joint = part.kind == "joint"
    who = f"{part.kind} '{part.name}': {interface.direction} interface '{name}'"
    at = interface.at.attributes["name"]
    if simulated and is_joint:
        yield from _simulated_interface(simulated, interface, who)
        return
    standard = [
        word
        for kind in (("joint",) if is_joint else ("imu", "force_torque"))
        for word in words("interfaces", kind)
    ]
    if suggested := _typo(name, standard):
        yield Finding(
            at, f"{who} is unknown; did you mean '{suggested}'?", _HELP, fix_value(at, suggested)
        )
    elif simulated and name not in standard:
        yield Finding(
            at,
            f"{who} is not one of {simulated.name} (such as {standard[0]})",
            _HELP,
            group_key=f"{simulated.name} sensor",
            severity=Severity.INFO,  # the real hardware may have it
        )


def _simulated_interface(simulated: Hardware, interface: Interface, who: str) -> Findings:
    """An interface of a joint that the hardware of a simulation does not have."""
    name = interface.name
    known = simulated.commands if interface.direction == "command" else _SIMULATED_STATES
    if name not in known:
        is_extra = interface.direction == "state" and not _typo(name, known)
        yield Finding(
            interface.at.attributes["name"],
            f"{who} is not one of {simulated.name} ({', '.join(known)})",
            _HELP,
            group_key=f"{simulated.name} {interface.direction}",
            severity=Severity.INFO if is_extra else None,  # the real hardware may have it
        )


def _hardware_interfaces(context: Context) -> Findings:
    simulated = _has_default_simulation(context)
    known = [*words("transmission", "interfaces"), *words("transmission", "unprefixed")]
    simulable = [*words("transmission", "gazebo"), *words("transmission", "unprefixed")]
    for joint, transmission in driven_joints(context.model.transmissions):
        if is_of_pr2(transmission):
            continue
        elements = joint.all("hardwareInterface")
        for element in elements:
            name = element.text.strip()
            who = f"joint '{joint.get('name') or ''}': hardware interface '{name}'"
            suggested = "" if name in known else _typo(name, known)
            if suggested:
                message = f"{who} is unknown; did you mean '{suggested}'?"
                yield Finding(element, message, _HELP, fix_value(element, suggested))
            elif name and simulated and element is elements[0] and name not in simulable:
                # Gazebo reads the first one.
                message = f"{who} is not one of gazebo_ros_control ({', '.join(simulable[:3])})"
                yield Finding(element, message, _HELP)


def _has_default_simulation(context: Context) -> bool:
    """True for a gazebo_ros_control with the default hardware simulation."""
    for plugin in control_plugins(context.model):
        kind = plugin.at.child("robotSimType")
        if plugin.kind == "gazebo_ros_control":
            return kind is None or _is_default(kind)
    return False


def _is_default(kind: Element) -> bool:
    return kind.text.strip() in ("", DEFAULT_SIM)


def _typo(name: str, standard: Sequence[str]) -> str:
    """The standard name that differs from a name in one letter; empty if there is none."""
    if name in standard:
        return ""
    suggested = nearest(name, standard, TYPO) or ""
    return suggested if abs(len(suggested) - len(name)) <= 1 else ""

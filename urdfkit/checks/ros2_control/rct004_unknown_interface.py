"""An interface of a joint or sensor is not one that its hardware or its controllers know.

Other names than `position`, `velocity` and `effort` are legal: hardware and controller agree on
them. But a name that is nearly a standard one is a slip, and no controller finds it; and Gazebo's
hardware plugins pass over every other one. A sensor with a misspelt name stops the simulator with
an exception.

Sources:
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, rule
from urdfkit.ros.catalog.ros_control import hardware, words
from urdfkit.ros.ros_control import (
    components,
    control_plugins,
    driven_joints,
    is_of_pr2,
    reads_transmissions,
)
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import rewrite

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.ros_control import Component, ControlPart, Interface
    from urdfkit.text.document import Attribute, Element

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <axis xyz="0 0 1"/>
  <limit lower="-1" upper="1" effort="10" velocity="1"/>
</joint>
<ros2_control name="arm" type="system">
  <hardware>
    <plugin>mock_components/GenericSystem</plugin>
  </hardware>
  <joint name="shoulder">
    <command_interface name="positon"/>
    <state_interface name="position"/>
  </joint>
</ros2_control>"""
GOOD = BAD.replace("positon", "position")
FIXED = GOOD

#: What a simulated joint tells.
_SIMULATED_STATES = ("position", "velocity", "effort")


@rule(
    "RCT004",
    "unknown-interface",
    Severity.WARNING,
    help="correct the name of the interface",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for component in components(subject.model):
        for part in component.parts:
            for interface in part.interfaces:
                yield from _of_ros2(component, part, interface)
    if subject.model.transmissions and reads_transmissions(subject.targets):
        yield from _of_ros1(subject)


def _of_ros2(component: Component, part: ControlPart, interface: Interface) -> Iterator[Finding]:
    name = interface.name
    if not name or part.kind == "gpio":
        return
    simulated = hardware().get(component.hardware)
    is_joint = part.kind == "joint"
    who = f"{part.kind} '{part.name}': {interface.direction} interface '{name}'"
    at = interface.at.attributes["name"]
    if simulated and is_joint:
        known = simulated.commands if interface.direction == "command" else _SIMULATED_STATES
        if name not in known:
            yield Finding(at, f"{who} is none that {simulated.name} has ({', '.join(known)})")
        return
    standard = [
        word
        for kind in (("joint",) if is_joint else ("imu", "force_torque"))
        for word in words("interfaces", kind)
    ]
    if suggested := _mistake(name, standard):
        yield Finding(at, f"{who} is nearly '{suggested}'", fix=_fix(at, suggested))
    elif simulated and name not in standard:
        yield Finding(at, f"{who} is none that {simulated.name} has (such as {standard[0]})")


def _of_ros1(subject: Subject) -> Iterator[Finding]:
    simulated = _has_default_simulation(subject)
    known = [*words("transmission", "interfaces"), *words("transmission", "unprefixed")]
    simulable = [*words("transmission", "gazebo"), *words("transmission", "unprefixed")]
    for joint, transmission in driven_joints(subject.model):
        if is_of_pr2(transmission):
            continue
        for element in joint.all("hardwareInterface"):
            name = element.text.strip()
            who = f"joint '{joint.get('name') or ''}': hardware interface '{name}'"
            suggested = "" if name in known else _mistake(name, known)
            if suggested:
                yield Finding(
                    element, f"{who} is nearly '{suggested}'", fix=_fix(element, suggested)
                )
            elif name and simulated and name not in simulable:
                yield Finding(
                    element,
                    f"{who} is none that gazebo_ros_control knows ({', '.join(simulable[:3])}); "
                    "its hardware fails to start",
                )


def _has_default_simulation(subject: Subject) -> bool:
    """True with a gazebo_ros_control whose joints are simulated by its own code."""
    for plugin in control_plugins(subject.model):
        kind = plugin.at.child("robotSimType")
        if plugin.kind == "gazebo_ros_control":
            return kind is None or _is_default(kind)
    return False


def _is_default(kind: Element) -> bool:
    return kind.text.strip() in ("", "gazebo_ros_control/DefaultRobotHWSim")


def _fix(at: Element | Attribute, suggested: str) -> Fix | None:
    edits = rewrite(at, suggested)
    return Fix.of(f"write {suggested}", edits)


def _mistake(name: str, standard: list[str]) -> str:
    """The standard name of which a name is a slip: one letter more, less or other."""
    if name in standard:
        return ""
    suggested = nearest(name, standard, 0.85) or ""
    return suggested if abs(len(suggested) - len(name)) <= 1 else ""

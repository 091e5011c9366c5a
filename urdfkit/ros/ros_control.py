"""``<transmission>`` and ``<ros2_control>`` in a model, and the plugins that run their controllers.

The reader is tolerant, as in ``model``: missing parts are None or empty, and reported by rules.
Source: the parsers of ros_control (noetic) and ros2_control (humble to rolling).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfkit.core.record import Record
from urdfkit.robot.model import RobotModel
from urdfkit.robot.values import number
from urdfkit.ros import RosDescription
from urdfkit.ros.catalog.ros_control import control_plugin, simulated_hardware
from urdfkit.ros.targets import Targets
from urdfkit.text.document import Element

ROS1 = ("ros1", "classic-ros1")
ROS2 = ("ros2", "classic-ros2", "gz-fortress", "gz-harmonic", "gz-jetty")

#: Hardware that gazebo_ros_control simulates unless ``<robotSimType>`` names another class.
DEFAULT_SIM = "gazebo_ros_control/DefaultRobotHWSim"
#: In the names of a class of one's own for a simulator.
_SIMULATED = re.compile(r"(?i)gazebo|gz|ign|sim").search
#: Children of ``<ros2_control>`` that have interfaces.
_PARTS = ("joint", "sensor", "gpio")

#: Children of the PR2's transmissions that ros_control does not support.
_PR2_TAGS = (
    "mechanicalReduction",
    "motorTorqueConstant",
    "leftActuator",
    "rightActuator",
    "gap_joint",
    "flexJoint",
    "rollJoint",
)

_DIRECTIONS = {"command_interface": "command", "state_interface": "state"}


class Interface(Record):
    """``<command_interface>`` or ``<state_interface>``; ``direction`` is the word before it."""

    at: Element
    direction: str
    name: str

    def parameter(self, name: str) -> Element | None:
        return parameter(self.at, name)

    def bound(self, name: str) -> float | None:
        """``min`` or ``max`` as a number, in the unit of the interface; None without a number."""
        found = self.parameter(name)
        return number(found.text.strip()) if found else None


#: A condition of xacro with a plugin or the whole hardware in it.
_CONDITIONAL = (
    r"(?s)<xacro:(?:if|unless)\b(?:(?!</?xacro:(?:if|unless)\b).)*?<(?:hardware|plugin)\b"
)


class ControlPart(Record):
    """A ``<joint>``, ``<sensor>`` or ``<gpio>`` in ``<ros2_control>``; ``kind`` is its tag."""

    at: Element
    kind: str
    name: str
    interfaces: tuple[Interface, ...]

    def of(self, direction: str) -> list[Interface]:
        """Its ``command`` or ``state`` interfaces."""
        return [item for item in self.interfaces if item.direction == direction]


class Component(Record):
    """A ``<ros2_control>`` block."""

    at: Element  # the block
    name: str  # empty if missing
    plugin: Element | None  # the element with the hardware class, or None
    parts: tuple[ControlPart, ...]  # joints, sensors and GPIOs, in document order

    @property
    def hardware(self) -> str:
        """The hardware class; empty if missing."""
        return self.plugin.text.strip() if self.plugin else ""

    @property
    def has_conditional_plugin(self) -> bool:
        """True if arguments of the robot select the hardware class, or whether it has one."""
        return bool(re.search(_CONDITIONAL, self.at.tag_at.whole_span.text))

    @property
    def joints(self) -> list[ControlPart]:
        return [part for part in self.parts if part.kind == "joint"]

    @property
    def called(self) -> str:
        return f"<ros2_control> '{self.name}'" if self.name else "<ros2_control>"


class ControlPlugin(Record):
    """A plugin of Gazebo that runs controllers."""

    at: Element  # the ``<plugin>``
    kind: str  # its name in the catalogue, such as ``gz_ros2_control``
    filename: str  # as written


def components(model: RobotModel) -> list[Component]:
    return [_component(element) for element in model.ros2_controls]


def has_no_simulated_hardware(model: RobotModel) -> bool:
    """True for a robot whose ``<ros2_control>`` names hardware, but none of a simulator."""
    hardware = [name for component in components(model) if (name := component.hardware)]
    known = simulated_hardware()
    return bool(hardware) and not any(name in known or _SIMULATED(name) for name in hardware)


def control_plugins(model: RobotModel) -> list[ControlPlugin]:
    """The plugins that run controllers, in document order."""
    plugins: list[ControlPlugin] = []
    for block in model.gazebo:
        for plugin in block.all("plugin"):
            filename = plugin.get("filename") or ""
            kind = control_plugin(filename) if "control" in filename else None
            if kind:
                plugins.append(ControlPlugin(plugin, kind, filename))
    return plugins


def namespace_of(plugin: Element) -> Element | None:
    """The namespace that a control plugin of ROS 2 gives its controller manager."""
    ros = plugin.child("ros")
    return ros.child("namespace") if ros else None


def parameter(element: Element, name: str) -> Element | None:
    return next((found for found in element.all("param") if found.get("name") == name), None)


def called(transmission: Element) -> str:
    """Name of a transmission for messages."""
    name = transmission.get("name")
    return f"transmission '{name}'" if name else "a transmission"


def is_of_pr2(transmission: Element) -> bool:
    """True for the legacy format that only the PR2's controller manager reads."""
    kind = transmission.get("type")
    if kind is None or transmission.child("type"):
        return False
    return "pr2" in kind or any(child.tag in _PR2_TAGS for child in transmission.children)


def reads_transmissions(targets: Targets) -> bool:
    """True unless the targets are only of ROS 2.

    ROS 2 ignores the transmissions of ROS 1, so that defects in them have no effect.
    """
    return targets.any_of(ROS1) or not targets.any_of(ROS2)


def driven_joints(transmissions: Iterable[Element]) -> Iterator[tuple[Element, Element]]:
    """The joints of all transmissions, each with its transmission."""
    for transmission in transmissions:
        for joint in transmission.all("joint"):
            yield joint, transmission


def joints_and_owners(description: RosDescription) -> Iterator[tuple[Element, str]]:
    """The joints of ros2_control and of transmissions that are read, with their owners."""
    for component in components(description.model):
        for joint in component.joints:
            yield joint.at, component.called
    transmissions = description.model.transmissions
    if transmissions and reads_transmissions(description.targets):
        for element, transmission in driven_joints(transmissions):
            yield element, called(transmission)


def _component(element: Element) -> Component:
    hardware = element.child("hardware")
    parts = tuple(_part(child) for child in element.children if child.tag in _PARTS)
    plugin = hardware.child("plugin") if hardware else None
    return Component(element, element.get("name") or "", plugin, parts)


def _part(element: Element) -> ControlPart:
    interfaces = tuple(
        Interface(child, _DIRECTIONS[child.tag], child.get("name") or "")
        for child in element.children
        if child.tag in _DIRECTIONS
    )
    return ControlPart(element, element.tag, element.get("name") or "", interfaces)

"""A `<ros2_control>` block has unknown elements, names or interfaces, or invalid values.

The parser of ros2_control throws an exception and the controller manager does not start, if

- the block holds an unknown element: "invalid tag name";
- a name is missing: "no attribute name in tag", or the `role` of a joint in a transmission;
- `rw_rate` is not a positive integer, nor the `size` of an interface of a GPIO;
- the type is missing or is not `system`, `actuator` or `sensor`; capital letters count. An
  `actuator` has one joint.

Reported as a warning are unknown elements in a joint, sensor or GPIO, which are ignored; an
interface whose name is nearly a standard one, or that the simulator does not offer; a misspelt
`initial_value`, or one outside of a state interface; values of `min`, `max` and `initial_value`
that are not numbers; a misspelt `data_type`; and an `is_async` that is neither true nor false.
Interfaces with other names are legal, since hardware and controller agree on them. `<ec_module>` is
read by the EtherCAT driver. The `<hardwareInterface>` of a transmission of ROS 1 is checked in the
same way.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
    ros2_control, mock components: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/mock_components_userdoc.rst
    ethercat_driver_ros2: https://github.com/ICube-Robotics/ethercat_driver_ros2
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
"""

from collections.abc import Iterator

from urdfkit.checks.ros2_control.interfaces import invalid_interfaces
from urdfkit.checks.ros2_control.parameters import invalid_values
from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.catalog.ros_control import component_types, grammar
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml, driven_xml
from urdfkit.ros.ros_control import Component, components
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_tag, fix_value
from urdfkit.text.grammar import is_expression

_JOINT = driven_xml("shoulder").replace("joint", "joints")
BAD = robot_xml(SHOULDER, control_xml("mock_components/GenericSystem", _JOINT))
FIXED = GOOD = BAD.replace("joints", "joint")

#: Similarity from which an unknown tag is a typo.
_TYPO = 0.8
#: A tag with a prefix, such as a call that nothing expands, is reported elsewhere.
_PREFIX = ":"


@rule(
    Severity.ERROR,
    help="use the elements of <ros2_control>: hardware, joint, sensor, gpio, transmission",
)
def check(context: Context) -> Findings:
    for component in components(context.model):
        block = component.at
        yield from _elements(block)
        yield from _type(component)
        for transmission in block.all("transmission"):
            yield from _roles(transmission)
        yield from invalid_values(component)
    for finding in invalid_interfaces(context):
        yield finding._replace(severity=finding.severity or Severity.WARNING)


def _roles(transmission: Element) -> Findings:
    for part in transmission.children:
        if part.tag in ("joint", "actuator") and not part.get("role"):
            message = f"<{part.tag}> of a transmission has no role"
            yield Finding(part, message, f'add role="{part.tag}1"')


def _elements(block: Element) -> Findings:
    """Unknown elements, and elements without a name."""
    tags = grammar()
    known = tags["ros2_control"].children
    for child in block.children:
        if child.tag not in known and _PREFIX not in child.tag:
            message = f"<ros2_control>: unknown element <{child.tag}>"
            message += did_you_mean(child.tag, known)
            yield Finding(child, message, fix=fix_tag(child, nearest(child.tag, known, _TYPO)))
    for element in _named(block):
        if not element.get("name"):
            yield Finding(element, f"<{element.tag}> has no name", "add a name")
    stack = [child for child in reversed(block.children) if child.tag in tags]
    while stack:
        element = stack.pop()
        known = tags[element.tag].children
        name = element.get("name")
        who = f"{element.tag} '{name}'" if name else f"<{element.tag}>"
        for child in element.children:
            if child.tag not in known and _PREFIX not in child.tag:
                message = f"{who} in <ros2_control>: unknown element <{child.tag}>"
                yield Finding(
                    child,
                    message + did_you_mean(child.tag, known),
                    "fix the name of the element, or remove it",
                    fix_tag(child, nearest(child.tag, known, _TYPO)),
                    severity=Severity.WARNING,
                )
        if element.tag != "transmission":  # it has joints and actuators of its own
            stack += [child for child in reversed(element.children) if child.tag in tags]


def _named(block: Element) -> Iterator[Element]:
    """What needs a name: the block, its parts, their interfaces and parameters."""
    yield block
    tags = grammar()
    for child in block.children:
        if child.tag in tags and "name" in tags[child.tag].required:
            yield child
        for inner in child.children:
            if inner.tag in ("command_interface", "state_interface", "param"):
                yield inner
                yield from inner.all("param")


def _type(component: Component) -> Findings:
    known = component_types()
    kind = component.at.attributes.get("type")
    help = f"write type={', '.join(known)}"
    if kind is None:
        yield Finding(component.at, f"{component.called} has no type", help)
    elif kind.value not in known and not is_expression(kind.value):
        message = f"{component.called}: type '{kind.value}' is not one of {', '.join(known)}"
        fix = fix_value(kind, nearest(kind.value, known))
        yield Finding(kind, message + did_you_mean(kind.value, known), help, fix)
    elif kind.value == "actuator" and len(component.joints) > 1:
        message = f"{component.called}: type actuator with {len(component.joints)} joints, not 1"
        yield Finding(kind, message, 'write type="system"')

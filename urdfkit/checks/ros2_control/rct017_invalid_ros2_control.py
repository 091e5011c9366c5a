"""A `<ros2_control>` block has unknown elements, names or interfaces, or invalid values.

The parser of ros2_control throws an exception and the controller manager does not start, if

- the block contains an unknown element: "invalid tag name";
- a name is missing ("no attribute name in tag"), or the `role` of a joint in a transmission (an
  empty name of the block is a warning if it does not come from an argument);
- `rw_rate`, or the `size` of an interface of a GPIO, is not a positive integer;
- the type is missing, or an `actuator` has more than one joint; or the type is not `system`,
  `actuator` or `sensor` (case-sensitive): then the block is not loaded, and its interfaces are
  missing (a warning if the robot's own hardware in another block may export them, or if Gazebo's,
  which goes on without them, is there).

Warnings are unknown elements in a joint, sensor or GPIO, which are ignored, as are unknown
attributes (an info, unless misspelt); a misspelt parameter of mock hardware; an interface whose
name is misspelt, or that the simulator does not offer; a misspelt `initial_value`, or one outside
of a state interface, from which Gazebo reads it; a second `<plugin>`, which is not loaded; values
of `min`, `max` and `initial_value` that are not numbers; a misspelt `data_type`; and an `is_async`
that is neither true nor false. Since Jazzy the hardware has a node of the name of the block, so a
warning is a name with other characters than letters, digits and _: "Invalid node name", and the
hardware is not initialized. Other names of interfaces are valid: hardware and controller define
them. Unknown elements are an info in a block for the robot's own hardware, which gets the text of
the URDF and may read them, as the EtherCAT driver reads `<ec_module>`. The `<hardwareInterface>` of
a transmission of ROS 1 is checked in the same way.

Sources:
    ros2_control, component_parser.cpp: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/src/component_parser.cpp
    ros2_control, hardware_component_interface.cpp: https://github.com/ros-controls/ros2_control/blob/jazzy/hardware_interface/src/hardware_component_interface.cpp
    ros2_control, interfaces: https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
    ros2_control, mock components: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/mock_components_userdoc.rst
    ethercat_driver_ros2: https://github.com/ICube-Robotics/ethercat_driver_ros2
    gz_ros2_control, gz_system.cpp: https://github.com/ros-controls/gz_ros2_control/blob/rolling/gz_ros2_control/src/gz_system.cpp
"""

import re
from collections.abc import Iterator

from urdfkit.checks.ros2_control.interface_names import invalid_interfaces
from urdfkit.core.suggest import CLOSE_TYPO, TYPO, did_you_mean, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.robot.values import number
from urdfkit.ros.catalog.ros_control import component_types, grammar, mock_parameters
from urdfkit.ros.gazebo.samples import SHOULDER, control_xml, driven_xml
from urdfkit.ros.ros_control import Component, ControlPart, components
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_tag, fix_value
from urdfkit.text.grammar import is_expression

_JOINT = driven_xml("shoulder").replace("joint", "joints")
BAD = robot_xml(SHOULDER, control_xml("mock_components/GenericSystem", _JOINT))
FIXED = GOOD = BAD.replace("joints", "joint")
#: A tag with a prefix, such as an unexpanded macro call, is reported by other rules.
_PREFIX = ":"
_NUMBERS = ("min", "max", "initial_value")
#: Packages of hardware that does not read an initial value of a joint.
_KNOWN = (
    "fake_components", "gazebo_ros2_control", "gz_ros2_control", "ign_ros2_control",
    "mock_components",
)  # fmt: skip
_MOCK = ("mock_components/", "fake_components/")
_GAZEBO = ("gazebo_ros2_control", "gz_ros2_control", "ign_ros2_control")
#: What rcl accepts as the name of a node.
_NODE_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
#: The usual types of interfaces.
_DATA_TYPES = ("double", "bool")


@rule(
    Severity.ERROR,
    help="use the elements of <ros2_control>: hardware, joint, sensor, gpio, transmission",
)
def check(context: Context) -> Findings:
    blocks = components(context.model)
    lenient = sum(map(_is_lenient, blocks)) if any(map(_has_unknown_type, blocks)) else 0
    for component in blocks:
        block = component.at
        yield from _elements(component)
        yield from _type(component, lenient)
        yield from _name(component)
        yield from _second_plugin(component)
        for transmission in block.all("transmission"):
            yield from _roles(transmission)
        yield from _invalid_values(component)
    for finding in invalid_interfaces(context):
        yield finding._replace(severity=finding.severity or Severity.WARNING)


def _roles(transmission: Element) -> Findings:
    for part in transmission.children:
        # The parser accepts an empty role, which the loaders of ros2_control do not use.
        if part.tag in ("joint", "actuator") and part.get("role") is None:
            message = f"<{part.tag}> of a transmission has no role"
            yield Finding(part, message, f'add role="{part.tag}1"')


def _elements(component: Component) -> Findings:
    """Unknown elements, and elements without a name."""
    block, tags = component.at, grammar()
    known = tags["ros2_control"].children
    for child in block.children:
        if child.tag not in known and _PREFIX not in child.tag:
            message = f"<ros2_control>: unknown element <{child.tag}>"
            message += did_you_mean(child.tag, known)
            yield Finding(child, message, fix=fix_tag(child, nearest(child.tag, known, TYPO)))
    for element in _named(block):
        written = element.attributes.get("name")
        # The parser accepts an empty name, and a launch file may pass the argument that it is.
        if not (written and (written.value or (element is block and not written.literal))):
            # Jazzy and later call a node by that of the block.
            severity = Severity.WARNING if written and element is block else None
            message = f"<{element.tag}> has no name"
            yield Finding(element, message, "add a name", severity=severity)
    stack = [child for child in reversed(block.children) if child.tag in tags]
    while stack:
        element = stack.pop()
        known = tags[element.tag].children
        name = element.get("name")
        who = f"{element.tag} '{name}'" if name else f"<{element.tag}>"
        yield from _attributes(element, who, tags[element.tag].attributes)
        for child in element.children:
            if child.tag not in known and _PREFIX not in child.tag:
                yield _unknown(child, who, known, is_read=_is_own(component))
        if element.tag != "transmission":  # which has other joints and actuators
            stack += [child for child in reversed(element.children) if child.tag in tags]


def _unknown(element: Element, who: str, known: tuple[str, ...], is_read: bool) -> Finding:
    """An unknown element of a part; hardware of the robot's own gets the text of the URDF."""
    suggested = nearest(element.tag, known, TYPO)
    is_read = is_read and not suggested
    return Finding(
        element,
        f"{who} in <ros2_control>: unknown element <{element.tag}>"
        + did_you_mean(element.tag, known),
        "remove it, unless the hardware reads it"
        if is_read
        else "fix the name of the element, or remove it",
        fix_tag(element, suggested),
        severity=Severity.INFO if is_read else Severity.WARNING,
    )


def _is_own(component: Component) -> bool:
    """True for hardware that is neither a simulator's nor mock hardware."""
    return bool(component.hardware) and component.hardware.partition("/")[0] not in _KNOWN


def _attributes(element: Element, who: str, known: tuple[str, ...]) -> Findings:
    """Attributes that the parser does not read: an info, unless they seem to matter."""
    for attribute in element.attributes.values():
        name = attribute.name
        if name in known or _PREFIX in name:
            continue
        is_prefix = "prefix" in name
        matters = is_prefix or nearest(name, known, CLOSE_TYPO)
        yield Finding(
            attribute,
            f"{who} in <ros2_control>: unknown attribute '{name}' (ignored)"
            + did_you_mean(name, known),
            "remove it; a prefix is part of the name"
            if is_prefix
            else "fix its name, or remove it",
            group_key=f"{element.tag} {name}",
            severity=Severity.WARNING if matters else Severity.INFO,
        )


def _named(block: Element) -> Iterator[Element]:
    """Elements that require a name: the block, its parts, their interfaces and parameters."""
    yield block
    tags = grammar()
    for child in block.children:
        if child.tag in tags and "name" in tags[child.tag].required:
            yield child
        for inner in child.children:
            if inner.tag in ("command_interface", "state_interface", "param"):
                yield inner
                yield from inner.all("param")


def _is_lenient(component: Component) -> bool:
    """True for hardware that may lack the interfaces of another block.

    The robot's own may export them, and Gazebo's goes on without; so is mock hardware that other
    arguments replace.
    """
    name = component.hardware
    return bool(name) and (not name.startswith(_MOCK) or component.has_conditional_plugin)


def _has_unknown_type(component: Component) -> bool:
    kind = component.at.get("type")
    return kind is not None and kind not in component_types() and not is_expression(kind)


def _type(component: Component, lenient: int) -> Findings:
    """A missing or unknown type, of which ros2_control loads nothing.

    Args:
        lenient: number of blocks whose hardware may lack the interfaces of others.
    """
    known = component_types()
    kind = component.at.attributes.get("type")
    help = f"write type={', '.join(known)}"
    if kind is None:
        yield Finding(component.at, f"{component.called} has no type", help)
    elif kind.value not in known and not is_expression(kind.value):
        message = f"{component.called}: type '{kind.value}' is not one of {', '.join(known)}"
        suggested = nearest(kind.value, known)
        goes_on = lenient > _is_lenient(component) and not suggested
        yield Finding(
            kind,
            message + did_you_mean(kind.value, known),
            help,
            fix_value(kind, suggested),
            severity=Severity.WARNING if goes_on else None,
        )
    elif kind.value == "actuator" and len(component.joints) > 1:
        message = f"{component.called}: type actuator with {len(component.joints)} joints, not 1"
        yield Finding(kind, message, 'write type="system"')


def _name(component: Component) -> Findings:
    """A name that the node of the hardware, which has it in lower case, cannot have."""
    written = component.at.attributes.get("name")
    if written is None or is_expression(written.value):
        return
    name = written.value.replace("/", "_")
    if name and not _NODE_NAME.fullmatch(name):
        allowed = re.sub(r"[^A-Za-z0-9_]", "_", name)
        allowed = f"_{allowed}" if allowed[0].isdigit() else allowed
        message = f"{component.called}: its node in Jazzy and later cannot have this name"
        help = f"write {allowed}: only letters, digits and _ are allowed"
        yield Finding(written, message, help, severity=Severity.WARNING)


def _second_plugin(component: Component) -> Findings:
    """Another plugin of a hardware, of which only the first is loaded."""
    hardware = component.plugin.parent if component.plugin else None
    for plugin in hardware.all("plugin")[1:] if hardware else ():
        message = f"{component.called}: only the first <plugin> is loaded, {component.hardware}"
        yield Finding(plugin, message, "remove one", severity=Severity.WARNING)


def _invalid_values(component: Component) -> Findings:
    """Invalid attributes of a block, and attributes and parameters of its interfaces."""
    rate = component.at.attributes.get("rw_rate")
    if rate is not None and not _is_count(rate.value, least=0):
        message = f"{component.called}: rw_rate is '{rate.value}', not a positive integer"
        yield Finding(rate, message, "write the rate in Hz, or remove it")
    is_async = component.at.attributes.get("is_async")
    if is_async is not None and not _is_boolean(is_async.value):
        message = f"{component.called}: is_async is '{is_async.value}', which is read as false"
        yield Finding(is_async, message, "write true or false", severity=Severity.WARNING)
    yield from _mock_parameters(component)
    is_known = component.hardware.partition("/")[0] in _KNOWN
    for part in component.parts:
        for element in part.at.all("param") if is_known else ():
            if element.get("name") == "initial_value":
                message = f"{part.kind} '{part.name}': initial_value is not read here, only in a "
                message += "state_interface"
                help = "move it into its <state_interface>"
                yield Finding(element, message, help, severity=Severity.WARNING)
        yield from _unread_initial(component, part)
        for interface in part.interfaces:
            who = f"{part.kind} '{part.name}', {interface.name}"
            yield from _size(part.kind, who, interface.at)
            yield from _data_type(who, interface.at)
            for element in interface.at.all("param"):
                yield from _parameter(who, element)


def _unread_initial(component: Component, part: ControlPart) -> Findings:
    """An initial value at a command interface, which Gazebo reads of the state interface only."""
    if component.hardware.partition("/")[0] not in _GAZEBO:
        return
    initial = {
        (interface.at.tag, interface.name): element
        for interface in part.interfaces
        for element in interface.at.all("param")
        if element.get("name") == "initial_value"
    }
    for (tag, name), element in initial.items():
        if tag == "command_interface" and ("state_interface", name) not in initial:
            message = f"{part.kind} '{part.name}', {name}: initial_value of a command_interface is "
            message += "not read"
            help = f'move it into <state_interface name="{name}">'
            yield Finding(element, message, help, severity=Severity.WARNING)


def _mock_parameters(component: Component) -> Findings:
    """Misspelt parameters of mock hardware; the others may be those of the real one."""
    block = component.plugin.parent if component.plugin else None
    if block is None or not component.hardware.startswith(_MOCK):
        return
    known = mock_parameters()
    for element in block.all("param"):
        name = element.attributes.get("name")
        suggested = nearest(name.value, known, CLOSE_TYPO) if name else ""
        if name and suggested and name.value not in known:
            message = f"unknown parameter '{name.value}' of mock hardware; did you mean "
            message += f"'{suggested}'?"
            fix = fix_value(name, suggested)
            yield Finding(name, message, f"write {suggested}", fix, severity=Severity.WARNING)


def _size(kind: str, who: str, interface: Element) -> Findings:
    """Only the parser of a GPIO reads the size, and rejects the robot if it is invalid."""
    size = interface.attributes.get("size")
    if size is not None and not _is_count(size.value, least=1):
        message = f"{who}: size is '{size.value}', not a positive integer"
        severity = None if kind == "gpio" else Severity.WARNING
        yield Finding(size, message, "write the number of values", severity=severity)


def _data_type(who: str, interface: Element) -> Findings:
    """Misspelt data types only: hardware may define other types."""
    kind = interface.attributes.get("data_type")
    if kind is None or kind.value in _DATA_TYPES or is_expression(kind.value):
        return
    if suggested := nearest(kind.value, _DATA_TYPES, TYPO):
        message = f"{who}: unknown data_type '{kind.value}'; did you mean '{suggested}'?"
        fix = fix_value(kind, suggested)
        yield Finding(kind, message, f"write {suggested}", fix, severity=Severity.WARNING)


def _is_boolean(text: str) -> bool:
    return is_expression(text) or text.lower() == "false" or text in ("true", "True")


def _is_count(text: str, least: int) -> bool:
    return is_expression(text) or (text.isascii() and text.isdigit() and int(text) >= least)


def _parameter(who: str, element: Element) -> Findings:
    name, text = element.attributes.get("name"), element.text.strip()
    if name is None:
        return
    if name.value in _NUMBERS:
        if number(text) is None and not is_expression(text):
            shown = f"'{text}'" if text else "empty"
            message = f"{who}: parameter '{name.value}' is {shown}, not a number"
            lacks_dollar = text[:1] == "{" and text[-1:] == "}" and _is_python(text[1:-1])
            help = f"write ${text}: xacro needs the dollar" if lacks_dollar else "write a number"
            yield Finding(
                element, message, help, group_key="not a number", severity=Severity.WARNING
            )
    elif suggested := nearest(name.value, ("initial_value",), CLOSE_TYPO):
        fix = fix_value(name, suggested)
        message = f"{who}: unknown parameter '{name.value}'; did you mean '{suggested}'?"
        yield Finding(name, message, f"write {suggested}", fix, severity=Severity.WARNING)


def _is_python(text: str) -> bool:
    from urdfkit.text import python_source  # rarely needed

    try:
        python_source.parse(text.strip())
    except SyntaxError:
        return False
    return True

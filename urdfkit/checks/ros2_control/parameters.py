"""Attributes and parameters in ``<ros2_control>`` with invalid values."""

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.robot.values import number
from urdfkit.ros.ros_control import Component
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression

_NUMBERS = ("min", "max", "initial_value")
#: Packages of hardware that reads no initial value of a joint.
_KNOWN = (
    "fake_components", "gazebo_ros2_control", "gz_ros2_control", "ign_ros2_control",
    "mock_components",
)  # fmt: skip
#: The usual types of interfaces, and the similarity from which another name is a typo.
_DATA_TYPES, _TYPO_OF_TYPE = ("double", "bool"), 0.8
#: Similarity from which an unknown name is a typo.
_TYPO = 0.85


def invalid_values(component: Component) -> Findings:
    """The attributes of a block and of interfaces, and the parameters of these."""
    rate = component.at.attributes.get("rw_rate")
    if rate is not None and not _is_count(rate.value, least=0):
        message = f"{component.called}: rw_rate is '{rate.value}', not a positive integer"
        yield Finding(rate, message, "write the rate in Hz, or remove it")
    is_async = component.at.attributes.get("is_async")
    if is_async is not None and not _is_boolean(is_async.value):
        message = f"{component.called}: is_async is '{is_async.value}', which is read as false"
        yield Finding(is_async, message, "write true or false", severity=Severity.WARNING)
    is_known = component.hardware.partition("/")[0] in _KNOWN
    for part in component.parts:
        for element in part.at.all("param") if is_known else ():
            if element.get("name") == "initial_value":
                message = f"{part.kind} '{part.name}': initial_value is not read here, only in a "
                message += "state_interface"
                help = "move it into the <state_interface> that it is for"
                yield Finding(element, message, help, severity=Severity.WARNING)
        for interface in part.interfaces:
            who = f"{part.kind} '{part.name}', {interface.name}"
            yield from _size(part.kind, who, interface.at)
            yield from _data_type(who, interface.at)
            for element in interface.at.all("param"):
                yield from _parameter(who, element)


def _size(kind: str, who: str, interface: Element) -> Findings:
    """Only the parser of a GPIO reads the size, and rejects the robot for it."""
    size = interface.attributes.get("size")
    if size is not None and not _is_count(size.value, least=1):
        message = f"{who}: size is '{size.value}', not a positive integer"
        severity = None if kind == "gpio" else Severity.WARNING
        yield Finding(size, message, "write the number of values", severity=severity)


def _data_type(who: str, interface: Element) -> Findings:
    """Hardware may have types of its own, whose names are no typos."""
    kind = interface.attributes.get("data_type")
    if kind is None or kind.value in _DATA_TYPES or is_expression(kind.value):
        return
    if suggested := nearest(kind.value, _DATA_TYPES, _TYPO_OF_TYPE):
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
    elif suggested := nearest(name.value, ("initial_value",), _TYPO):
        fix = fix_value(name, suggested)
        message = f"{who}: unknown parameter '{name.value}'; did you mean '{suggested}'?"
        yield Finding(name, message, f"write {suggested}", fix, severity=Severity.WARNING)


def _is_python(text: str) -> bool:
    from urdfkit.text import python_source  # for few robots

    try:
        python_source.parse(text.strip())
    except SyntaxError:
        return False
    return True

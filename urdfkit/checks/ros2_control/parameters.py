"""Parameters and integer attributes in ``<ros2_control>`` with invalid values."""

from __future__ import annotations

from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.robot.model import number
from urdfkit.ros.ros_control import Component
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.grammar import is_expression

_NUMBERS = ("min", "max", "initial_value")
#: Similarity from which an unknown name is a typo.
_TYPO = 0.85


def invalid_values(component: Component) -> Findings:
    """The parameters of interfaces, ``rw_rate`` and ``size``."""
    yield from _integer(component.at, "rw_rate", 0, component.called)
    for part in component.parts:
        for interface in part.interfaces:
            who = f"{part.kind} '{part.name}', {interface.name}"
            yield from _integer(interface.at, "size", 1, who)
            for element in interface.at.all("param"):
                yield from _parameter(who, element)


def _integer(element: Element, name: str, least: int, who: str) -> Findings:
    attribute = element.attributes.get(name)
    text = attribute.value.strip() if attribute else ""
    if attribute is None or is_expression(text):
        return
    if not (text.isascii() and text.isdecimal() and int(text) >= least):
        message = f"{who}: {name} is '{text}', must be an integer >= {least}"
        help = f"write an integer >= {least}"
        yield Finding(attribute, message, help, severity=Severity.WARNING)


def _parameter(who: str, element: Element) -> Findings:
    name, text = element.attributes.get("name"), element.text.strip()
    if name is None:
        return
    if name.value in _NUMBERS:
        if number(text) is None and not is_expression(text):
            shown = f"'{text}'" if text else "empty"
            message = f"{who}: parameter '{name.value}' is {shown}, not a number"
            yield Finding(
                element,
                message,
                "write a number",
                alike="not a number",
                severity=Severity.WARNING,
            )
    elif suggested := nearest(name.value, ("initial_value",), _TYPO):
        fix = fix_value(name, suggested)
        message = f"{who}: unknown parameter '{name.value}'; did you mean '{suggested}'?"
        yield Finding(name, message, f"write {suggested}", fix, severity=Severity.WARNING)

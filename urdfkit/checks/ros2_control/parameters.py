"""Parameters of interfaces in ``<ros2_control>`` with invalid values."""

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
    """The parameters of interfaces."""
    for part in component.parts:
        for interface in part.interfaces:
            for element in interface.at.all("param"):
                yield from _parameter(f"{part.kind} '{part.name}', {interface.name}", element)


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

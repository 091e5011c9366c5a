"""A property repeats the constant pi, with fewer digits.

Expressions provide `pi`, exact to the last bit. With a pi of eight digits a wheel is off by a few
nanometres, which matters only if two frames are compared; with 3.14 it is off by a millimetre at
one metre. Write `${pi}`.

Sources:
    xacro: https://wiki.ros.org/xacro
"""

import re
from math import pi

from urdfkit.lint.rules import Context, Finding, Findings, Fix, Location, Need, Severity, rule
from urdfkit.robot.samples import xacro_xml
from urdfkit.robot.values import number
from urdfkit.text.diagnostic import Edit
from urdfkit.text.editing.edits import remove_spans
from urdfkit.xacro.definitions import Definition

BAD = xacro_xml('<xacro:property name="PI" value="3.1415926"/>', '<link name="base_${PI}"/>')
FIXED = BAD.replace("3.1415926", "${pi}")
GOOD = BAD.replace("PI", "width").replace("3.1415926", "3.2")

_NAME = r"(?i)(^|_|\b)m?_?pi($|_)"
#: Distance below which a value is pi with any name.
_TOLERANCE = 1e-4
#: Distance below which a value is pi if its name contains pi.
_TOLERANCE_OF_NAMED = 2e-2


@rule(Severity.INFO, needs=(Need.XACRO,), help="write ${pi}, which expressions know")
def check(context: Context) -> Findings:
    for definition in context.xacro.properties:
        value = number(definition.attributes.get("value"))
        if value is None or value == pi:
            continue
        off = abs(value - pi)
        if off < _TOLERANCE or (off < _TOLERANCE_OF_NAMED and re.search(_NAME, definition.name)):
            message = f"property '{definition.name}' is {value}, {off:.1e} off the built-in pi"
            fix = Fix("use the built-in pi", _edits(definition))
            yield Finding(Location(definition.tag.span, definition.frame), message, fix=fix)


def _edits(definition: Definition) -> tuple[Edit, ...]:
    """Sets the property to ${pi}; removes a property that is named pi itself."""
    if definition.name == "pi":
        return remove_spans([definition.tag.whole_span])
    return (Edit(definition.tag.attribute_spans()["value"], "${pi}"),)

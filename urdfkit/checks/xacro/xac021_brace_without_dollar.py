"""The dollar before a brace is missing.

xacro replaces `${name}`, but not `{name}`: the link is then named `{prefix}wheel`, and a macro that
is called twice creates two links of that name. In the reference of a `<gazebo>` block the name
matches no link, and Gazebo drops the block.

Sources:
    xacro, properties: https://github.com/ros/xacro/wiki#properties-and-property-blocks
    measured: 7 of 676 public models
"""

import re

from urdfkit.lint.rules import NAMES, Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import element_xml, joint_xml, xacro_xml
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import fix_value
from urdfkit.xacro import Xacro

NAME = "example.urdf.xacro"
BAD = xacro_xml(
    element_xml(
        'xacro:macro name="wheel" params="side"',
        '<link name="${side}_wheel"/>',
        joint_xml("continuous", name="{side}_axle", child="${side}_wheel"),
    ),
    '<link name="base"/>',
    '<xacro:wheel side="left"/>',
)
FIXED = GOOD = BAD.replace('"{side}', '"${side}')

_BRACES = r"(?<![$\w}])\{([A-Za-z_]\w*)\}"


@rule(Severity.WARNING, needs=(Need.XACRO, Need.MODEL), hides_parts=NAMES)
def check(context: Context) -> Findings:
    known = _names(context.xacro)
    for element in context.document.root.walk():
        values: list[tuple[Element | Attribute, str]] = [(element, element.text.strip())]
        values += [(attribute, attribute.value) for attribute in element.attributes.values()]
        for at, value in values:
            braced = re.findall(_BRACES, value) if "{" in value else ()
            named = [name for name in braced if name in known]
            if named:
                right = re.sub(_BRACES, r"${\1}", value)
                message = f"xacro does not replace {{{named[0]}}}: the dollar before it is missing"
                yield Finding(at, message, f"write ${{{named[0]}}}", fix_value(at, right))


def _names(xacro: Xacro) -> set[str]:
    """The names that an expression may use: properties, and the parameters of macros."""
    names = {definition.name.removeprefix("**") for definition in xacro.properties}
    for macro in xacro.macros:
        names.update(re.findall(r"[A-Za-z_]\w*", macro.attributes.get("params", "")))
    return names

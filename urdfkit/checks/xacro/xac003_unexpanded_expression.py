"""An expression or a tag of xacro is not expanded.

- In a plain URDF. Parsers do not replace `${...}` and `$(...)`: numbers cannot be read, and names
  keep the text: an error. They ignore `<xacro:...>` without a message, so that the elements of the
  macro are missing from the robot: a warning. The file is a xacro without the namespace
  declaration, a part of a xacro that another file includes, or was saved before expansion. urdfkit
  reads a file as a xacro if a launch file of the workspace passes it to xacro. What a launch file
  that names the robot replaces in its text, as in `.replace("$(find arm)", path)`, is accepted.
- In a xacro, because the dollar is missing. xacro replaces `${name}`, but not `{name}`: the link is
  then named `{prefix}wheel`, and a macro that is called twice creates two links of that name. In
  the reference of a `<gazebo>` block the name matches no link, and Gazebo drops the block. A
  warning.

Sources:
    xacro: https://wiki.ros.org/xacro
    xacro, properties: https://github.com/ros/xacro/wiki#properties-and-property-blocks
    measured: 17 of 676 public .urdf files are a xacro, 7 models lack a dollar
"""

import os
import re

from urdfkit.lint.rules import NAMES, Context, Finding, Findings, Severity, reported, rule
from urdfkit.robot.samples import element_xml, joint_xml, xacro_xml
from urdfkit.text.document import Attribute, Element
from urdfkit.text.editing.edits import fix_value
from urdfkit.text.file_kinds import is_extension
from urdfkit.text.grammar import is_expression
from urdfkit.workspace.includes import is_named_by_arguments
from urdfkit.workspace.launch_files import directories_of_launch_files, launch_files
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

#: The substitutions of xacro.
_SUBSTITUTION = r"\$\(\s*(?:anon|arg|cwd|dirname|env|eval|find|optenv)\b"

#: What a launch file in Python replaces: ``.replace("$(find arm)", path)``.
_REPLACE = re.compile(rb"\.replace\(\s*['\"](\$[({][^'\"\n]{1,200}[)}])['\"]").findall

_BRACES = r"(?<![$\w}])\{([A-Za-z_]\w*)\}"


@rule(
    Severity.ERROR,
    help="expand the file with xacro first; a xacro declares "
    'xmlns:xacro="http://www.ros.org/wiki/xacro"',
    hides_parts=NAMES,
    depends_on_arguments=True,
)
def check(context: Context) -> Findings:
    for finding in reported(context, "XAC003"):
        help = "include the file that defines the macro, or delete the call"
        lowered = Severity.INFO if is_extension(context.document.root) else Severity.WARNING
        yield finding._replace(help=help, severity=lowered)
    data = context.source.data
    if context.reading.xacro:
        yield from _without_dollar(context.document.root, _names(context.reading.xacro))
    elif (b"${" in data or b"$(" in data) and not _is_part(context):
        yield from _expressions(context.document.root, _replaced(context))


def _is_part(context: Context) -> bool:
    """True for a URDF whose only expressions are arguments of a xacro that includes it by name."""
    expressions = set(re.findall(rb"\$(?:\(|\{)[^)}]*[)}]", context.source.data))
    arguments = [re.fullmatch(rb"\$\(\s*arg\s+(\w+)\s*\)", each) for each in expressions]
    names = {match.group(1).decode() for match in arguments if match}
    path, packages = context.source.path, context.resolver.packages
    return len(names) == len(expressions) and is_named_by_arguments(path, names, packages)


def _replaced(context: Context) -> set[str]:
    """The expressions that launch files replace in the text of the robot."""
    found: set[str] = set()
    name = os.path.basename(context.source.path).encode()
    for place in directories_of_launch_files(context.source.path, context.resolver):
        for launch in launch_files(*place, context.resolver):
            if name in launch.data:
                found.update(each.decode(errors="replace") for each in _REPLACE(launch.data))
    return found


def _expressions(root: Element, replaced: set[str]) -> Findings:
    """Expressions in a plain URDF."""

    def rest(text: str) -> str:
        for expression in replaced:
            text = text.replace(expression, "")
        return text

    for element in root.walk():
        for attribute in element.attributes.values():
            if is_expression(rest(attribute.value)):
                yield _unexpanded(attribute, f'{attribute.name}="{attribute.value}"')
        text = element.text.strip()
        if not element.children and _is_of_xacro(rest(text)):
            yield _unexpanded(element, f"<{element.tag}>{text}")


def _unexpanded(at: Attribute | Element, text: str) -> Finding:
    # If a launch file runs xacro, it replaces $(...) without a namespace declaration, too.
    severity = None if "${" in text else Severity.WARNING
    return Finding(at, f"{text} is not expanded", severity=severity, group_key="expression")


def _is_of_xacro(text: str) -> bool:
    """False for ``$(name)`` alone, a placeholder in a plugin's settings for a launch file."""
    return is_expression(text) and ("${" in text or re.search(_SUBSTITUTION, text) is not None)


def _without_dollar(root: Element, known: set[str]) -> Findings:
    """Known names in braces without a dollar, in what xacro expanded."""
    for element in root.walk():
        values: list[tuple[Element | Attribute, str]] = [(element, element.text.strip())]
        values += [(attribute, attribute.value) for attribute in element.attributes.values()]
        for at, value in values:
            braced = re.findall(_BRACES, value) if "{" in value else ()
            named = [name for name in braced if name in known]
            if named:
                right = re.sub(_BRACES, r"${\1}", value)
                yield Finding(
                    at,
                    f"xacro does not replace {{{named[0]}}}: the dollar before it is missing",
                    f"write ${{{named[0]}}}",
                    fix_value(at, right),
                    severity=Severity.WARNING,
                )


def _names(xacro: Xacro) -> set[str]:
    """The names that an expression may use: properties, and the parameters of macros."""
    names = {definition.name.removeprefix("**") for definition in xacro.properties}
    for macro in xacro.macros:
        names.update(re.findall(r"[A-Za-z_]\w*", macro.attributes.get("params", "")))
    return names

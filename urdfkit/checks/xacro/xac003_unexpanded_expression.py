"""A plain URDF contains an expression or a tag of xacro.

URDF parsers do not replace `${...}` and `$(...)`: numbers cannot be read, and names keep the text:
an error. They ignore `<xacro:...>` without a message, so that the elements of the macro are missing
from the robot: a warning. The file is a xacro without the namespace declaration, a part of a xacro
that another file includes, or was saved before expansion. urdfkit reads a file as a xacro if a
launch file of the workspace passes it to xacro.

Sources:
    xacro: https://wiki.ros.org/xacro
    measured: 17 of 676 public .urdf files are a xacro
"""

import re

from urdfkit.lint.rules import NAMES, Context, Finding, Findings, Severity, reported, rule
from urdfkit.text.document import Attribute, Element
from urdfkit.text.file_kinds import is_extension
from urdfkit.text.grammar import is_expression

BAD = '<link name="${side}_arm"/>'
GOOD = '<link name="left_arm"/>'

#: The substitutions of xacro.
_SUBSTITUTION = r"\$\(\s*(?:anon|arg|cwd|dirname|env|eval|find|optenv)\b"


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
    if context.reading.xacro or (b"${" not in data and b"$(" not in data):
        return
    for element in context.document.root.walk():
        for attribute in element.attributes.values():
            if is_expression(attribute.value):
                yield _unexpanded(attribute, f'{attribute.name}="{attribute.value}"')
        text = element.text.strip()
        if not element.children and _is_of_xacro(text):
            yield _unexpanded(element, f"<{element.tag}>{text}")


def _unexpanded(at: Attribute | Element, text: str) -> Finding:
    # If a launch file runs xacro, it replaces $(...) without a namespace declaration, too.
    severity = None if "${" in text else Severity.WARNING
    return Finding(at, f"{text} is not expanded", severity=severity)


def _is_of_xacro(text: str) -> bool:
    """False for ``$(name)`` alone, a placeholder in a plugin's settings for a launch file."""
    return is_expression(text) and ("${" in text or re.search(_SUBSTITUTION, text) is not None)

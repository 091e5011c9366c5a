"""A condition compares a boolean with the text 'true' or 'false', which it never equals.

xacro converts the value of a property, of an argument and of a macro's parameter to a boolean if it
is `true` or `false`. `${with_camera == 'true'}` is False for any value, and the camera is always
missing; with `!=` it is always there. Write `${with_camera}`, or `${not with_camera}`. A value in
inner quotes (`value="'true'"`) remains text, and `'$(arg with_camera)' == 'true'` compares text
with text: then `'True'` differs from `true`, the default of the argument.

Sources:
    xacro, __init__.py (get_boolean_value): https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
    ros/xacro#145: https://github.com/ros/xacro/issues/145
"""

import re
from collections.abc import Iterator

from urdfkit.lint.rules import Context, Finding, Findings, Need, Severity, rule
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.comments import blank_comments
from urdfkit.text.source import Source, Span

BAD = xacro_xml(
    '<xacro:property name="camera" value="true"/>',
    '<link name="base"/>',
    "<xacro:if value=\"${camera == 'true'}\"><gazebo/></xacro:if>",
)
GOOD = BAD.replace("${camera == 'true'}", "${camera}")

_CONDITION = rb"""<xacro:(?:if|unless)\s+value\s*=\s*"\s*\$\{([^{}"]*)\}\s*\""""
_TEXTS = rb"""^[\s(]*'\$\(arg (\w+)\)'\s*(?:==|!=)\s*'([Tt]rue|[Ff]alse)'[\s)]*$"""
_DEFAULT = r"""<xacro:arg\s+name\s*=\s*"{}"\s+default\s*=\s*"([Tt]rue|[Ff]alse)\""""
_COMPARED = rb"""^[\s(]*([A-Za-z_]\w*)\s*(==|!=)\s*'(?:[Tt]rue|[Ff]alse)'[\s)]*$"""


@rule(Severity.WARNING, needs=(Need.XACRO,), help="write ${NAME} or ${not NAME}")
def check(context: Context) -> Findings:
    for source in context.xacro.sources:
        for name, operator, span in _comparisons(source, _COMPARED):
            if not _is_text(name, context):
                result = "False" if operator == "==" else "True"
                message = f"'{span.text}' is always {result}: xacro makes a boolean of '{name}'"
                yield Finding(span, message)
        for name, word, span in _comparisons(source, _TEXTS):
            default = _default(name, context)
            if word != default and word.lower() == default.lower():
                message = f"'{word}' is never equal to '{default}', the default of '{name}'"
                yield Finding(span, message, f"write $(arg {name}) alone, or '{default}'")


def _comparisons(source: Source, pattern: bytes) -> Iterator[tuple[str, str, Span]]:
    """The two groups of a pattern in the conditions that it matches, and the conditions."""
    if b"rue'" not in source.data and b"alse'" not in source.data:
        return
    for condition in re.finditer(_CONDITION, bytes(blank_comments(source.data))):
        if found := re.match(pattern, condition.group(1)):
            first, second = (group.decode() for group in found.groups())
            yield first, second, Span(source, *condition.span(1))


def _default(name: str, context: Context) -> str:
    """The default of an argument, if all files that declare it agree on true or false."""
    pattern = _DEFAULT.format(name).encode()
    found = {text for source in context.xacro.sources for text in re.findall(pattern, source.data)}
    return found.pop().decode() if len(found) == 1 else ""


def _is_text(name: str, context: Context) -> bool:
    """True if a name has a quoted text as its value anywhere, or an expression with one."""
    given = rf"""\b{name}\s*:?=\s*"[^"]*'""".encode()
    defined = rf"""name\s*=\s*"{name}"[^<>]*"[^"<>]*'""".encode()
    texts = [source.data for source in context.xacro.sources]
    return any(re.search(given, text) or re.search(defined, text) for text in texts)
